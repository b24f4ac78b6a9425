// The system of a step of backward Euler by Drape, Eigen 3.4, CHOLMOD (through Eigen) and hypre 2.26. The others get
// the whole matrix, and the time of assembling it is not counted, nor that of analysing its pattern, which never
// changes.

#include <HYPRE.h>
#include <HYPRE_IJ_mv.h>
#include <HYPRE_parcsr_ls.h>
#include <fmt/core.h>

#include <Eigen/CholmodSupport>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include "drape/base/input_error.h"
#include "drape/integrate/integrator.h"
#include "drape/model/force_sweep.h"
#include "integrate/krylov.h"
#include "integrate/multigrid.h"
#include "runner.h"

namespace drape::peers {
namespace {

using Matrix = Eigen::SparseMatrix<Real>;
using Vector = Eigen::VectorXd;
using Block = Jacobian::Block;
using PointRows = Eigen::Matrix<Real, Eigen::Dynamic, 3, Eigen::RowMajor>;

constexpr Real picture = Real(1) / 60;  // s

Vector by_particle(const PointRows& points) { return Eigen::Map<const Vector>(points.data(), points.size()); }

/// (m I + h D + h^2 K) dv = b of a sheet that was let go some time ago, hung by two corners; pinned: m dv = 0.
struct NewtonStep {
    ClothModel model;
    Jacobian jacobian{model.grid, Hessian::Clamped, Kernels::Vector};
    Points b{model.grid.particles(), 3};
    Real own = 0;  ///< of the diagonal, without springs [kg]
    Matrix matrix;
    Vector right;

    NewtonStep(const ClothParameters& sheet, Real time) : model(make_cloth_model(sheet)) {
        ClothState state = make_rest_state(sheet);
        const auto integrator = make_integrator({.integrator = IntegratorKind::BackwardEuler}, model.grid);
        for (Real now = 0; now < time; now += picture) integrator->step(model, state, picture);
        ForceSweep(model.grid, Kernels::Vector).compute(model, state.x, state.v, b);
        jacobian.linearise(model, state.x, state.v);
        jacobian.add_product(-picture, 0, state.v, b);
        b *= picture;
        clear_pinned(b);
        right = by_particle(b);
        own = model.particle_mass + picture * jacobian.drag();

        std::vector<Eigen::Triplet<Real>> entries;
        const auto add = [&entries](int p, int q, const Block& block) {
            for (int i = 0; i < 9; ++i) entries.emplace_back(3 * p + i / 3, 3 * q + i % 3, block(i / 3, i % 3));
        };
        for (int p = 0; p < model.grid.particles(); ++p) add(p, p, own * Block::Identity());
        jacobian.for_each_block(picture * picture, picture, [&](int p, int q, const Block& block) {
            if (model.pinned(p) || model.pinned(q)) return;
            add(p, q, block);
            if (p != q) add(q, p, block);
        });
        matrix.resize(right.size(), right.size());
        matrix.setFromTriplets(entries.begin(), entries.end());
    }

    void clear_pinned(Points& points) const {
        for (int p = 0; p < points.rows(); ++p) {
            if (model.pinned(p)) points.row(p).setZero();
        }
    }
};

/// A solve of Drape's, without a matrix: conjugate gradients with a cycle of multigrid, or the inverse diagonal blocks.
struct OurSolve {
    const NewtonStep& step;
    bool with_multigrid;
    Real limit = 1;  ///< in the norm that it stops in
    Multigrid multigrid{step.model.grid, Kernels::Vector};
    krylov::ConjugateGradients gradients{step.model.grid.particles()};
    std::vector<Block> inverses{};  ///< of the blocks of the diagonal
    Points dv{step.b.rows(), 3};

    void prepare_matrix() {
        if (with_multigrid) return multigrid.build(step.model, step.jacobian, picture * picture, picture);
        inverses.assign(static_cast<std::size_t>(dv.rows()), step.own * Block::Identity());
        step.jacobian.for_each_block(picture * picture, picture, [this](int p, int q, const Block& block) {
            if (p == q) inverses[static_cast<std::size_t>(p)] += block;
        });
        for (Block& block : inverses) block = block.inverse().eval();
    }

    int solve() {
        const auto apply = [this](const Points& u, Points& y) {
            y = step.model.particle_mass * u;
            step.jacobian.add_product(picture * picture, picture, u, y);
            step.clear_pinned(y);
        };
        const auto precondition = [this](const Points& r, Points& z) {
            if (with_multigrid) return multigrid.cycle(r, z);
            for (int p = 0; p < r.rows(); ++p) z.row(p) = r.row(p) * inverses[static_cast<std::size_t>(p)];
        };
        return gradients.solve(step.b, dv, limit, 10'000, apply, precondition).iterations;
    }
};

/// A cycle of hypre's algebraic multigrid as a preconditioner of Eigen. It is told that a particle has three unknowns.
class BoomerAmg {
public:
    BoomerAmg() = default;
    BoomerAmg(const BoomerAmg&) = delete;
    BoomerAmg& operator=(const BoomerAmg&) = delete;
    ~BoomerAmg() {
        HYPRE_BoomerAMGDestroy(amg_);
        HYPRE_IJMatrixDestroy(matrix_);
        for (Column& column : columns_) HYPRE_IJVectorDestroy(column.ij);
    }

    /// Symmetric: its columns are its rows.
    BoomerAmg& analyzePattern(const Matrix& a) {
        const auto last = static_cast<HYPRE_BigInt>(a.cols() - 1);
        HYPRE_IJMatrixCreate(MPI_COMM_SELF, 0, last, 0, last, &matrix_);
        HYPRE_IJMatrixSetObjectType(matrix_, HYPRE_PARCSR);
        HYPRE_IJMatrixInitialize(matrix_);
        for (HYPRE_BigInt row = 0; row <= last; ++row) {
            const int begin = a.outerIndexPtr()[row];
            HYPRE_Int count = a.outerIndexPtr()[row + 1] - begin;
            HYPRE_IJMatrixSetValues(matrix_, 1, &count, &row, a.innerIndexPtr() + begin, a.valuePtr() + begin);
        }
        HYPRE_IJMatrixAssemble(matrix_);
        HYPRE_IJMatrixGetObject(matrix_, reinterpret_cast<void**>(&whole_));
        for (Column& column : columns_) {
            HYPRE_IJVectorCreate(MPI_COMM_SELF, 0, last, &column.ij);
            HYPRE_IJVectorSetObjectType(column.ij, HYPRE_PARCSR);
            HYPRE_IJVectorInitialize(column.ij);
            HYPRE_IJVectorAssemble(column.ij);
            HYPRE_IJVectorGetObject(column.ij, reinterpret_cast<void**>(&column.whole));
        }
        return *this;
    }

    BoomerAmg& factorize(const Matrix& /*a*/) {
        if (amg_ != nullptr) HYPRE_BoomerAMGDestroy(amg_);
        HYPRE_BoomerAMGCreate(&amg_);
        HYPRE_BoomerAMGSetNumFunctions(amg_, 3);
        HYPRE_BoomerAMGSetStrongThreshold(amg_, 0.5);
        HYPRE_BoomerAMGSetRelaxType(amg_, 6);  // symmetric Gauss-Seidel
        HYPRE_BoomerAMGSetTol(amg_, 0);
        HYPRE_BoomerAMGSetMaxIter(amg_, 1);
        HYPRE_BoomerAMGSetup(amg_, whole_, columns_[0].whole, columns_[1].whole);
        return *this;
    }

    [[nodiscard]] Vector solve(const Vector& r) const {
        Vector z(r.size());
        HYPRE_IJVectorSetValues(columns_[0].ij, static_cast<HYPRE_Int>(r.size()), nullptr, r.data());
        HYPRE_ParVectorSetConstantValues(columns_[1].whole, 0);
        HYPRE_BoomerAMGSolve(amg_, whole_, columns_[0].whole, columns_[1].whole);
        HYPRE_IJVectorGetValues(columns_[1].ij, static_cast<HYPRE_Int>(r.size()), nullptr, z.data());
        return z;
    }

    [[nodiscard]] static Eigen::ComputationInfo info() { return Eigen::Success; }

private:
    struct Column {
        HYPRE_IJVector ij = nullptr;
        HYPRE_ParVector whole = nullptr;
    };
    HYPRE_IJMatrix matrix_ = nullptr;
    HYPRE_ParCSRMatrix whole_ = nullptr;
    std::array<Column, 2> columns_;  ///< right-hand side, and solution
    HYPRE_Solver amg_ = nullptr;
};

/// All solvers on one system, to |b - A x| <= tolerance |b|.
struct SolveRace {
    const NewtonStep& step;
    Real tolerance;
    Runners runners{};
    std::vector<std::shared_ptr<int>> iterations{};  ///< of each one's last solve; 0: it is direct

    [[nodiscard]] Real residual(const Vector& x) const {
        return (step.right - step.matrix * x).norm() / step.right.norm();
    }

    /// @param prepare_matrix what each new matrix takes
    /// @param solve gives its iterations, and solution the last x
    template <class Prepare, class Solve, class Solution>
    void add(const std::string& name, Prepare prepare_matrix, Solve solve, Solution solution) {
        const auto count = std::make_shared<int>();
        iterations.push_back(count);
        const auto check = [=, this] {
            // Solvers stop by a recursion, which drifts from the residual itself
            const Real left = residual(solution());
            if (!(left <= Real(1.01) * tolerance)) throw RunError(fmt::format("residual {}, not {}", left, tolerance));
        };
        runners.push_back(std::make_unique<OneFrame>(
            name, [] {}, prepare_matrix, [=] { *count = solve(); }, check));
    }

    /// Drape's stops in another norm: at the largest tolerance there that is small enough here.
    void add_ours(const std::string& name, bool with_multigrid) {
        const std::shared_ptr<OurSolve> ours(new OurSolve{step, with_multigrid, 4 * tolerance});  // it cannot be copied
        ours->prepare_matrix();
        for (ours->solve(); residual(by_particle(ours->dv)) > tolerance; ours->solve()) ours->limit *= Real(0.9);
        add(
            name, [=] { ours->prepare_matrix(); }, [=] { return ours->solve(); },
            [=] { return by_particle(ours->dv); });
    }

    /// What has Eigen's interface.
    template <class Solver>
    void add_eigen(const std::string& name) {
        const auto solver = std::make_shared<Solver>();
        const auto x = std::make_shared<Vector>();
        constexpr bool iterates = requires { solver->iterations(); };
        if constexpr (iterates) solver->setTolerance(tolerance);
        solver->analyzePattern(step.matrix);
        const auto solve = [=, this]() -> int {
            *x = solver->solve(step.right);
            if constexpr (iterates) return static_cast<int>(solver->iterations());
            return 0;
        };
        add(
            name, [=, this] { solver->factorize(step.matrix); }, solve, [=] { return *x; });
    }
};

template <class Preconditioner>
using Gradients = Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper, Preconditioner>;

void race_on(const std::string& motion, int side, bool quick, std::ostream& out) {
    ClothParameters sheet;
    sheet.particles = {side, side};
    sheet.pinned.kind = Pins::Kind::Two;
    sheet.drag = Real(0.5) / static_cast<Real>(side * side);
    const NewtonStep step(sheet, motion == "flat" ? Real(0.2) : Real(1));
    for (const Real tolerance : {Real(1e-4), Real(1e-6)}) {
        SolveRace race{step, tolerance};
        race.add_ours("Drape multigrid", true);
        race.add_ours("Drape diagonal blocks", false);
        race.add_eigen<Gradients<Eigen::DiagonalPreconditioner<Real>>>("Eigen CG diagonal");
        race.add_eigen<Gradients<Eigen::IncompleteCholesky<Real>>>("Eigen CG IncompleteCholesky");
        race.add_eigen<Gradients<BoomerAmg>>("Eigen CG hypre BoomerAMG");
        race.add_eigen<Eigen::SimplicialLDLT<Matrix>>("Eigen SimplicialLDLT");
        race.add_eigen<Eigen::CholmodSupernodalLLT<Matrix>>("CHOLMOD supernodal");
        const std::vector<Result> results = take_turns(race.runners, quick ? 1 : 3);
        for (std::size_t m = 0; m < results.size(); ++m) {
            const Result& r = results[m];
            tell(out, fmt::format("{},{},{},{},{:.4g},{:.4g},{:.4g},{:.3g},{},{}", motion, side, tolerance, r.method,
                                  1e3 * r.update, 1e3 * r.query, 1e3 * r.total, r.total / results[0].total,
                                  *race.iterations[m], r.frames));
        }
    }
}

}  // namespace

void race_to_solve(bool quick, std::ostream& out) {
    MPI_Init(nullptr, nullptr);
    tell(out, "motion,side,tolerance,method,setup_ms,solve_ms,total_ms,ratio,iterations,runs");
    for (const char* motion : {"flat", "folds"}) {
        for (const int side : quick ? std::vector{24} : std::vector{32, 64, 128}) race_on(motion, side, quick, out);
    }
    MPI_Finalize();
}

}  // namespace drape::peers
