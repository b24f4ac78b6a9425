#include "multigrid.h"

// Between a level and the finer one before it: a node that is between two coarse ones has half of each (P), and gives
// half to each (P').

namespace drape {

void Multigrid::Level::restrict_from(const Vectors& fine) {
    for (int axis = 0; axis < 3; ++axis) {
        const float* const from = fine.col(axis).data();
        float *const between = rows.col(axis).data(), *const to = b.col(axis).data();
        for (int j = 0; j < finer.ny; ++j) {
            const float* const row = from + j * finer.nx;
            float* const sums = between + j * grid.nx;
            for (int i = 0; i < grid.nx; ++i) {
                if (!halves_columns()) {
                    sums[i] = row[i];
                    continue;
                }
                const float left = i > 0 ? row[2 * i - 1] : 0, right = 2 * i + 1 < finer.nx ? row[2 * i + 1] : 0;
                sums[i] = (2 * i < finer.nx ? row[2 * i] : 0) + (left + right) / 2;
            }
        }
        for (int j = 0; j < grid.ny; ++j) {
            const auto row = [&](int k) { return between + k * grid.nx; };
            for (int i = 0; i < grid.nx; ++i) {
                if (!halves_rows()) {
                    to[j * grid.nx + i] = row(j)[i];
                    continue;
                }
                const float above = j > 0 ? row(2 * j - 1)[i] : 0, below = 2 * j + 1 < finer.ny ? row(2 * j + 1)[i] : 0;
                to[j * grid.nx + i] = (2 * j < finer.ny ? row(2 * j)[i] : 0) + (above + below) / 2;
            }
        }
    }
}

void Multigrid::Level::add_correction(Vectors& fine) {
    for (int axis = 0; axis < 3; ++axis) {
        const float* const from = x.col(axis).data();
        float *const between = rows.col(axis).data(), *const to = fine.col(axis).data();
        for (int j = 0; j < finer.ny; ++j) {
            const bool is_between = halves_rows() && j % 2 != 0;
            const float* const above = from + (halves_rows() ? j / 2 : j) * grid.nx;
            for (int i = 0; i < grid.nx; ++i) {
                between[j * grid.nx + i] = is_between ? (above[i] + above[i + grid.nx]) / 2 : above[i];
            }
        }
        for (int j = 0; j < finer.ny; ++j) {
            const float* const row = between + j * grid.nx;
            for (int i = 0; i < finer.nx; ++i) {
                const bool is_between = halves_columns() && i % 2 != 0;
                const int left = halves_columns() ? i / 2 : i;
                to[j * finer.nx + i] += is_between ? (row[left] + row[left + 1]) / 2 : row[left];
            }
        }
    }
}

}  // namespace drape
