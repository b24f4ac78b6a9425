#include "drape/scene/mesh_file.h"

#include <assimp/BaseImporter.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <filesystem>
#include <iterator>
#include <memory>
#include <span>

#include "closed_mesh.h"
#include "drape/base/input_error.h"
#include "drape/base/input_file.h"

namespace drape {
namespace {

constexpr std::uintmax_t largest_file = 16 * 1024 * 1024;  // bytes
constexpr std::size_t longest_line = 4 * 1024, max_points = 100'000, max_triangles = 200'000;
constexpr double farthest_point = 1e3;  // m
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF", blanks = " \t";

/// The next word of a line, which is taken off it.
std::string_view next_word(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

void check_count(std::size_t count, std::size_t largest, const std::string& what, const std::string& place) {
    if (count <= largest) return;
    throw InputError(place + ": too many " + what + ": allowed at most " + std::to_string(largest));
}

/// The lines `v` and `f` of an OBJ file without their comments: words in whose place are no numbers are refused here,
/// where the line is known.
std::string points_and_faces(std::istream& in, const std::string& file) {
    NumberedLines lines{.in = in, .file = file, .longest = longest_line, .may_be_cut_off = true};
    std::string text;
    std::size_t points = 0, faces = 0;
    while (lines.next()) {
        std::string_view content = std::string_view(lines.line).substr(0, lines.line.find('#'));
        if (lines.number == 1 && content.starts_with(byte_order_mark)) content.remove_prefix(byte_order_mark.size());
        std::string_view rest = content;
        const std::string_view kind = next_word(rest);
        const bool is_point = kind == "v";
        if (!is_point && kind != "f") continue;
        check_count(is_point ? ++points : points, max_points, "points", lines.place());
        check_count(is_point ? faces : ++faces, max_triangles, "triangles", lines.place());
        for (int words = 0; words < 3 || rest.find_first_not_of(blanks) != rest.npos; ++words) {
            const std::string_view word = next_word(rest);
            const auto foreign = word.find_first_not_of(is_point ? "0123456789+-.eE" : "0123456789-/");
            if (!word.empty() && foreign == word.npos) continue;
            lines.fail(std::string(kind) + ": '" + shortened(word) + "': allowed " +
                       (is_point ? "three numbers" : "the numbers of three points or more"));
        }
        text.append(content).append("\n");
    }
    return faces > 0 ? text : "";
}

/// An STL file as the library knows it: text in small letters without a byte order mark, and bytes without any that
/// follow the last triangle.
std::string plain_stl(std::istream& in, const std::string& file) {
    constexpr std::size_t header = 80, counted_header = 84, facet = 50;
    std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (bytes.find('\0') == bytes.npos) {
        if (bytes.starts_with(byte_order_mark)) bytes.erase(0, byte_order_mark.size());
        for (char& c : bytes) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        return bytes;
    }
    std::size_t count = 0;
    for (std::size_t k = counted_header; k-- > header && k < bytes.size();) {
        count = count << 8 | static_cast<unsigned char>(bytes[k]);
    }
    if (const std::size_t size = counted_header + facet * count; bytes.size() >= size) return bytes.substr(0, size);
    throw InputError(file + ": " + std::to_string(bytes.size()) + " bytes: allowed at least " +
                     std::to_string(counted_header + facet * count) + ", for the " + std::to_string(count) +
                     " triangles that byte 80 says a binary STL file has");
}

/// The triangles of all meshes in a scene of the library.
std::vector<MeshTriangle> triangles_of(const aiScene& scene, const std::string& file) {
    std::vector<MeshTriangle> triangles;
    for (const aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
        for (const aiFace& face : std::span(mesh->mFaces, mesh->mNumFaces)) {
            if (face.mNumIndices != 3) continue;
            MeshTriangle& triangle = triangles.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) {
                const aiVector3D& p = mesh->mVertices[face.mIndices[k]];
                triangle[k] = Vec3(p.x, p.y, p.z);
                if ((triangle[k].array().abs() <= Real(farthest_point)).all()) continue;
                throw InputError(file + ": a point at " + point_text(triangle[k]) +
                                 ": allowed three numbers, each -1000 <= x <= 1000 m");
            }
        }
        check_count(triangles.size(), max_triangles, "triangles", file);
    }
    return triangles;
}

/// Leaves the library only what reads these formats: the others, which may guess from the content, are not tried on a
/// stranger's file.
void keep_reader_of(const std::string& format, Assimp::Importer& importer) {
    const std::size_t kept = importer.GetImporterIndex(format.c_str());
    for (std::size_t k = importer.GetImporterCount(); k-- > 0;) {
        if (k == kept) continue;
        const std::unique_ptr<Assimp::BaseImporter> other(importer.GetImporter(k));
        importer.UnregisterLoader(other.get());
    }
}

}  // namespace

std::string mesh_extension(const std::string& file) {
    std::string extension = std::filesystem::path(file).extension().string();
    for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return extension == ".stl" ? extension : ".obj";
}

TriangleMesh read_mesh(const std::string& file) {
    InputFile in(file, largest_file);
    return read_mesh(in, file);
}

TriangleMesh read_mesh(std::istream& in, const std::string& file) {
    const std::string format = mesh_extension(file);
    const std::string text = format == ".stl" ? plain_stl(in, file) : points_and_faces(in, file);
    if (text.empty()) return closed_mesh({}, file);
    Assimp::Importer importer;
    keep_reader_of(format, importer);
    const aiScene* scene =
        importer.ReadFileFromMemory(text.data(), text.size(), aiProcess_Triangulate, format.c_str() + 1);
    if (scene == nullptr) {
        throw InputError(file + ": not read by Assimp (" + shortened(importer.GetErrorString()) +
                         "): allowed a valid " + format.substr(1) + " file");
    }
    return closed_mesh(triangles_of(*scene, file), file);
}

}  // namespace drape
