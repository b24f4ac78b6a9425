#include "marks.h"

#include <algorithm>
#include <cstddef>

#include "cloth_mesh.h"
#include "solids.h"

namespace drape {

namespace {

struct ContactMark {
    float point[3];
    float normal[3];
};

struct SphereMark {
    float centre[3];
    float radius;
    float state;
};

/// An end of an edge.
struct EdgeMark {
    float point[3];
    float state;
};

constexpr int circles_per_sphere = 4;
constexpr int contact_vertices = 9;
constexpr float bend_lift = 0.22f;  // of the bend springs over the cloth, in spacings

void copy(const Vec3& from, float* to) {
    for (int axis = 0; axis < 3; ++axis) to[axis] = static_cast<float>(from[axis]);
}

}  // namespace

Marks::Marks(Gl& gl, StreamBuffer& stream)
    : gl_(gl),
      spring_program_(gl, "spring"),
      particle_program_(gl, "particle"),
      contact_program_(gl, "contact"),
      sphere_program_(gl, "bounding_sphere"),
      edge_program_(gl, "edge"),
      spring_array_(gl),
      contact_array_(gl),
      sphere_array_(gl),
      edge_array_(gl),
      spring_indices_(gl) {
    gl(glBindVertexArray, spring_array_.name());
    enable_cloth_attributes(gl);
    gl(glBindVertexArray, contact_array_.name());
    for (GLuint location = 0; location < 2; ++location) enable_attribute(gl, location, true);
    gl(glBindVertexArray, sphere_array_.name());
    for (GLuint location = 0; location < 3; ++location) enable_attribute(gl, location, true);
    gl(glBindVertexArray, edge_array_.name());
    for (GLuint location = 0; location < 2; ++location) enable_attribute(gl, location, false);
    place_springs(stream);
    place_contacts(stream);
    place_spheres(stream);
    place_edges(stream);
}

void Marks::place_springs(const StreamBuffer& stream) {
    gl_(glBindVertexArray, spring_array_.name());
    place_cloth_attributes(gl_, stream);
}

void Marks::place_contacts(const StreamBuffer& stream) {
    const std::size_t start = stream.place(Region::Contacts), stride = sizeof(ContactMark);
    gl_(glBindVertexArray, contact_array_.name());
    place_attribute(gl_, {0, 3, stride, start + offsetof(ContactMark, point)});
    place_attribute(gl_, {1, 3, stride, start + offsetof(ContactMark, normal)});
}

void Marks::place_spheres(const StreamBuffer& stream) {
    const std::size_t start = stream.place(Region::Spheres), stride = sizeof(SphereMark);
    gl_(glBindVertexArray, sphere_array_.name());
    place_attribute(gl_, {0, 3, stride, start + offsetof(SphereMark, centre)});
    place_attribute(gl_, {1, 1, stride, start + offsetof(SphereMark, radius)});
    place_attribute(gl_, {2, 1, stride, start + offsetof(SphereMark, state)});
}

void Marks::place_edges(const StreamBuffer& stream) {
    const std::size_t start = stream.place(Region::Edges), stride = sizeof(EdgeMark);
    gl_(glBindVertexArray, edge_array_.name());
    place_attribute(gl_, {0, 3, stride, start + offsetof(EdgeMark, point)});
    place_attribute(gl_, {1, 1, stride, start + offsetof(EdgeMark, state)});
}

int Marks::segments() const {
    constexpr std::size_t vertices_wanted = 300'000;
    const std::size_t share =
        vertices_wanted / (2 * circles_per_sphere * std::max<std::size_t>(bounds_.spheres.size(), 1));
    return static_cast<int>(std::clamp<std::size_t>(share, 8, 48));
}

void Marks::need(const FrameView& view, StreamBuffer& stream) {
    const ViewSettings& shown = view.settings->view;
    show_particles_ = shown.particles;
    contact_count_ = particle_count_ = 0;
    bounds_.clear();
    for (const ClothView& cloth : view.cloths) {
        particle_count_ += cloth.model.grid.particles();
        if (shown.contacts) contact_count_ += static_cast<int>(cloth.contacts.size());
    }
    if (shown.bounds) collect_bounds(view);
    stream.need(Region::Contacts, static_cast<std::size_t>(contact_count_) * sizeof(ContactMark));
    stream.need(Region::Spheres, bounds_.spheres.size() * sizeof(SphereMark));
    stream.need(Region::Edges, 2 * bounds_.edges.size() * sizeof(EdgeMark));
}

void Marks::collect_bounds(const FrameView& view) {
    for (const ClothView& cloth : view.cloths) {
        if (!cloth.hierarchy || cloth.hierarchy->levels() < 1) continue;
        touched_cells_.clear();
        for (const Contact& contact : cloth.contacts) touched_cells_.push_back(contact.triangle / 2);
        std::sort(touched_cells_.begin(), touched_cells_.end());
        touched_cells_.erase(std::unique(touched_cells_.begin(), touched_cells_.end()), touched_cells_.end());

        const int level = std::clamp(view.settings->view.level, 0, cloth.hierarchy->levels() - 1);
        cloth.hierarchy->nodes_at(level, nodes_);
        append_nodes(nodes_, cloth.hierarchy->slack(), cloth.model.grid, touched_cells_, bounds_);
    }
}

void Marks::arrange(const FrameView& view, const StreamBuffer& stream) {
    if (stream.moved(Region::Cloth)) place_springs(stream);
    if (stream.moved(Region::Contacts)) place_contacts(stream);
    if (stream.moved(Region::Spheres)) place_spheres(stream);
    if (stream.moved(Region::Edges)) place_edges(stream);
    if (show_particles_) index_springs(view);
}

void Marks::index_springs(const FrameView& view) {
    bool same = grids_.size() == view.cloths.size();
    for (std::size_t i = 0; same && i < grids_.size(); ++i) same = grids_[i] == view.cloths[i].model.grid;
    if (!view.cloths.empty()) {
        const ClothModel& model = view.cloths.front().model;
        spacing_ = static_cast<float>(std::min(model.hx, model.hy));
    }
    if (same) return;

    grids_.clear();
    SpringIndices springs;
    std::uint32_t first_vertex = 0;
    for (const ClothView& cloth : view.cloths) {
        grids_.push_back(cloth.model.grid);
        append_spring_indices(cloth.model.grid, first_vertex, springs);
        first_vertex += static_cast<std::uint32_t>(cloth.model.grid.particles());
    }
    structural_count_ = static_cast<int>(springs.structural.size() / 2);
    shear_count_ = static_cast<int>(springs.shear.size() / 2);
    bend_count_ = static_cast<int>(springs.bend.size() / 2);
    std::vector<std::uint32_t>& all = springs.structural;
    all.insert(all.end(), springs.shear.begin(), springs.shear.end());
    all.insert(all.end(), springs.bend.begin(), springs.bend.end());
    gl_(glBindVertexArray, spring_array_.name());
    gl_(glBindBuffer, GLenum{GL_ELEMENT_ARRAY_BUFFER}, spring_indices_.name());
    gl_(glBufferData, GLenum{GL_ELEMENT_ARRAY_BUFFER}, static_cast<GLsizeiptr>(all.size() * sizeof(std::uint32_t)),
        static_cast<const void*>(all.data()), GLenum{GL_STATIC_DRAW});
}

void Marks::fill(const FrameView& view, StreamBuffer& stream) const {
    if (contact_count_ > 0) {
        auto* mark = stream.data<ContactMark>(Region::Contacts);
        for (const ClothView& cloth : view.cloths) {
            for (const Contact& contact : cloth.contacts) {
                copy(contact.point, mark->point);
                copy(contact.normal, mark->normal);
                ++mark;
            }
        }
    }
    auto* sphere_mark = stream.data<SphereMark>(Region::Spheres);
    for (const Outlines::Sphere& sphere : bounds_.spheres) {
        copy(sphere.centre, sphere_mark->centre);
        sphere_mark->radius = static_cast<float>(sphere.radius);
        sphere_mark->state = static_cast<float>(sphere.state);
        ++sphere_mark;
    }
    auto* edge_mark = stream.data<EdgeMark>(Region::Edges);
    for (const Outlines::Edge& edge : bounds_.edges) {
        for (const Vec3* end : {&edge.from, &edge.to}) {
            copy(*end, edge_mark->point);
            edge_mark->state = static_cast<float>(edge.state);
            ++edge_mark;
        }
    }
}

void Marks::draw() {
    if (show_particles_) {
        const int plain = structural_count_ + shear_count_;
        spring_program_.use();
        gl_(glBindVertexArray, spring_array_.name());
        gl_(glVertexAttrib1f, 4u, 0.0f);
        gl_.draw_elements(GL_LINES, 2 * plain);
        gl_(glVertexAttrib1f, 4u, bend_lift * spacing_);
        gl_.draw_elements(GL_LINES, 2 * bend_count_, 2 * static_cast<std::size_t>(plain) * sizeof(std::uint32_t));
        particle_program_.use();
        gl_.draw_arrays(GL_POINTS, particle_count_);
    }
    if (!bounds_.spheres.empty()) {
        sphere_program_.use();
        gl_(glBindVertexArray, sphere_array_.name());
        gl_.draw_arrays_instanced(GL_LINES, 2 * circles_per_sphere * segments(),
                                  static_cast<int>(bounds_.spheres.size()));
    }
    if (!bounds_.edges.empty()) {
        edge_program_.use();
        gl_(glBindVertexArray, edge_array_.name());
        gl_.draw_arrays(GL_LINES, 2 * static_cast<int>(bounds_.edges.size()));
    }
    if (contact_count_ > 0) {
        contact_program_.use();
        gl_(glBindVertexArray, contact_array_.name());
        gl_.draw_arrays_instanced(GL_TRIANGLES, contact_vertices, contact_count_);
    }
}

}  // namespace drape
