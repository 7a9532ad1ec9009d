// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/vec.h"

namespace ew {

/// Collects rows of a Jacobian with their values.
class Rows {
  public:
    explicit Rows(Eigen::Index columns) : columns_(columns) {}
    void begin(double value) {
        values_.push_back(value);
        data_.resize(data_.size() + static_cast<std::size_t>(columns_), 0.0);
    }
    /// Adds a gradient with respect to one vertex to the current row.
    void add(int vertex, const Vec3& gradient) {
        double* row = data_.data() + data_.size() - columns_ + 3 * vertex;
        for (int i = 0; i < 3; ++i) row[i] += gradient(i);
    }
    Eigen::VectorXd values() const {
        return Eigen::Map<const Eigen::VectorXd>(values_.data(),
                                                 static_cast<Eigen::Index>(values_.size()));
    }
    Eigen::MatrixXd jacobian() const {
        using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        return Eigen::Map<const RowMajor>(data_.data(), static_cast<Eigen::Index>(values_.size()),
                                          columns_);
    }
    /// Scales every row to a gradient of length one, so that a value is about a distance.
    void normalise() {
        for (std::size_t r = 0; r < values_.size(); ++r) {
            double* row = data_.data() + static_cast<Eigen::Index>(r) * columns_;
            double norm = 0;
            for (Eigen::Index i = 0; i < columns_; ++i) norm += row[i] * row[i];
            norm = std::sqrt(norm);
            if (norm < 1e-12) continue;
            values_[r] /= norm;
            for (Eigen::Index i = 0; i < columns_; ++i) row[i] /= norm;
        }
    }

  private:
    Eigen::Index columns_;
    std::vector<double> values_;
    std::vector<double> data_;
};

}  // namespace ew
