#pragma once

#include <Eigen/Cholesky>
#include <array>
#include <vector>

#include "drape/model/jacobian.h"
#include "kernels/stencil_kernels.h"

namespace drape {

/// A preconditioner for A = m I + k_scale K + d_scale D that takes about as many iterations on every grid: one V-cycle
/// of multigrid, in single precision. A level has every second column and row of the one before, and a correction found
/// there is interpolated (P). Its matrix is P'AP (Galerkin), a stencil of 5 x 5 symmetric blocks, half of which are
/// kept. Chebyshev polynomials of the matrix and its diagonal blocks smooth before a correction and after it, alike, so
/// that the cycle is symmetric; the coarsest level is factored. Pinned particles take no part.
/// @cite tamstorf2015 @cite trottenberg2001
class Multigrid {
public:
    /// Makes room for the levels; nothing later allocates.
    Multigrid(const Grid& grid, Kernels kernels);

    /// Takes the matrix. Nothing is kept of the one before.
    /// @param jacobian clamped
    /// @par Cost O(n)
    void build(const ClothModel& model, const Jacobian& jacobian, Real k_scale, Real d_scale);

    /// z = about A^-1 r, zero at pinned particles.
    /// @pre `build` was called
    /// @par Cost O(n), that of about six products
    void cycle(const Points& r, Points& z);

private:
    static constexpr int blocks = kernels::StencilLayout::blocks, entries = kernels::StencilLayout::entries;
    using Vectors = Eigen::Array<float, Eigen::Dynamic, 3>;
    using Blocks = Eigen::Array<float, Eigen::Dynamic, entries>;  ///< xx, xy, xz, yy, yz, zz of each

    /// What of a coarse matrix a term of the finer one is added to: a block of a node, and how much of the term.
    struct Part {
        int node;  ///< from the coarse node at or before the term's first one
        int block;
        float weight;
    };

    /// Terms that join a node with another: where they are added, for even and odd columns and rows.
    struct Kind {
        int di, dj;  ///< from the first to the other
        std::array<std::vector<Part>, 4> parts;
    };

    /// The finest level, or one of every second column and row of a finer one, where that has more than two.
    struct Level {
        Grid finer, grid;
        std::vector<float> stencils;
        std::array<int, blocks> shifts{};  ///< from a node to the others of its stencil
        Blocks inverse;                    ///< of the diagonal blocks; zero where nothing moves
        double bound = 2;                  ///< of the spectrum of D^-1 A
        Vectors x, b, residual, step, divided;
        Vectors rows;  ///< scratch, of the finer level's rows
        Blocks line;   ///< scratch, of every one or every second term in a row
        std::vector<Kind> kinds;

        Kernels kernels;  ///< plain: products in plain code, with the same bits

        Level(const Grid& finer, const Grid& own, Kernels kernels_of_products);
        [[nodiscard]] bool is_finest() const { return grid == finer; }
        [[nodiscard]] bool halves_columns() const { return grid.nx != finer.nx; }
        [[nodiscard]] bool halves_rows() const { return grid.ny != finer.ny; }
        void plan(bool of_springs);
        void add(std::size_t kind, const Blocks& terms);
        void add_line(const Part& part, int node, int count);
        void add_matrix_of(const Level& before, Blocks& scratch);
        [[nodiscard]] std::array<float, entries> block(int node, int number) const;
        void invert_diagonal();
        void multiply_plainly(const Vectors& u, Vectors& y) const;
        void find_bound();
        void product(const Vectors& u, Vectors& y) const;
        void divide(const Vectors& r, Vectors& z) const;
        void smooth();
        void find_residual();
        void restrict_from(const Vectors& fine);
        void add_correction(Vectors& fine);
    };

    void solve(std::size_t number);
    void factor_coarsest();

    std::vector<int> pinned_;
    std::vector<Level> levels_;
    Blocks own_, terms_;  ///< scratch: of the particles alone, of one kind
    Eigen::MatrixXd dense_;
    Eigen::LLT<Eigen::MatrixXd> factors_;  ///< of the coarsest level
    Eigen::VectorXd unknowns_;
};

}  // namespace drape
