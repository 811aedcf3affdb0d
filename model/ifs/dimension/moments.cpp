// SPDX-License-Identifier: MIT
#include "ifs/dimension/moments.h"

#include "ifs/existence/conditioning.h"
#include "ifs/existence/expansion.h"
#include "ifs/existence/symmetric_square.h"
#include "ifs/linear/inverse.h"
#include "ifs/linear/symmetric_matrices.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ifs {

namespace {

using Real = long double;
template <int Size> using RealVector = Eigen::Matrix<Real, Size, 1>;
template <int Size> using RealMatrix = Eigen::Matrix<Real, Size, Size>;

constexpr Real unit = std::numeric_limits<Real>::epsilon();
constexpr Real shareUnit = 0x1p-52L; // relative error of a probability

// A double that is no less.
double above(Real error) {
    const double rounded = double(error) * (1 + 0x1p-50);
    return error > 0 ? std::max(rounded, std::numeric_limits<double>::denorm_min()) : rounded;
}

// A vector of which no component is off by more than its error.
template <int Size> struct Solution {
    RealVector<Size> value;
    RealVector<Size> error;
};

// The x with (I − A)x = b, where the entries of A and b are off by at most their errors, refined with R near
// (I − A)⁻¹ and enclosed by |x − x̃| ≤ |R|·|residual| / (1 − ‖I − R(I − A)‖). nullopt where that is not
// below 1.
template <int Size> class Equations {
public:
    static std::optional<Equations> of(const RealMatrix<Size>& a, const RealMatrix<Size>& error) {
        Equations result;
        result.m_complement = RealMatrix<Size>::Identity() - a;
        result.m_error = error + 2 * unit * (RealMatrix<Size>::Identity() + a.cwiseAbs());
        result.m_inverse = inverseOf(result.m_complement);
        if (!result.m_inverse.allFinite()) return std::nullopt;
        const RealMatrix<Size> size = result.m_inverse.cwiseAbs();
        const RealMatrix<Size> rest =
            (result.m_inverse * result.m_complement - RealMatrix<Size>::Identity()).cwiseAbs() +
            size * (result.m_error + (Size + 2) * unit * result.m_complement.cwiseAbs());
        result.m_rests = rest * (1 + 16 * unit);
        result.m_rest = result.m_rests.rowwise().sum().maxCoeff() * (1 + 16 * unit);
        return result.m_rest < 0.5L ? std::optional(result) : std::nullopt;
    }

    Solution<Size> solve(const RealVector<Size>& b, const RealVector<Size>& error) const {
        constexpr int refinements = 3;
        RealVector<Size> x = m_inverse * b;
        for (int n = 0; n < refinements; ++n)
            x += m_inverse * (b - m_complement * x);
        const RealVector<Size> size = x.cwiseAbs();
        const RealVector<Size> residual = (b - m_complement * x).cwiseAbs() + error + m_error * size +
                                          (Size + 3) * unit * (b.cwiseAbs() + m_complement.cwiseAbs() * size);
        const RealVector<Size> direct = (m_inverse.cwiseAbs() * residual) * (1 + 16 * unit);
        // Solves e ≤ direct + rests·e, starting from the largest e for all components.
        RealVector<Size> e = direct + RealVector<Size>::Constant(m_rest * direct.maxCoeff() / (1 - m_rest));
        for (int n = 0; n < refinements; ++n)
            e = (direct + m_rests * e) * (1 + 16 * unit);
        return {x, e};
    }

private:
    RealMatrix<Size> m_complement, m_error, m_inverse, m_rests;
    Real m_rest = 0;
};

// The maps where they stretch little, as long as that is known to help.
template <int Dim> Conditioned<Dim> inGoodCoordinates(const ActiveMaps<Dim>& active) {
    if (auto better = conditioned<Dim>(active.maps)) return *std::move(better);
    return {.image = {}, .maps = active.maps};
}

template <int Dim> class MomentsOf {
public:
    explicit MomentsOf(const ActiveMaps<Dim>& active) : m_seen(inGoodCoordinates(active)) {
        for (const double share : active.probabilities)
            m_shares.push_back(share);
        Real sum = 0;
        for (const Real share : m_shares)
            sum += share;
        for (Real& share : m_shares)
            share /= sum;
    }

    // Mean in the coordinates of m_seen.
    std::optional<Solution<Dim>> mean() const {
        RealMatrix<Dim> linear = RealMatrix<Dim>::Zero(), linearError = linear;
        RealVector<Dim> shift = RealVector<Dim>::Zero(), shiftError = shift;
        for (std::size_t i = 0; i < m_shares.size(); ++i) {
            const RealMatrix<Dim> part = m_shares[i] * linearPart(i);
            const RealVector<Dim> along = m_shares[i] * translation(i);
            linear += part;
            shift += along;
            linearError += shareUnit * part.cwiseAbs();
            shiftError += shareUnit * along.cwiseAbs();
        }
        linearError.array() += Real(m_seen.linearRounding) + unit * linear.cwiseAbs().maxCoeff();
        shiftError.array() += Real(m_seen.translationRounding) + unit * shift.cwiseAbs().maxCoeff();
        const double unsure = double(linearError.maxCoeff()) + 0x1p-52 * double(linear.cwiseAbs().maxCoeff());
        if (expansion<Dim>(linear.template cast<double>(), unsure) != Expansion::No) return std::nullopt;
        const auto equations = Equations<Dim>::of(linear, linearError);
        return equations ? std::optional(equations->solve(shift, shiftError)) : std::nullopt;
    }

    // Mean in coordinates x of a solution in coordinates y.
    Mean<Dim> placed(const Solution<Dim>& y) const {
        const RealMatrix<Dim> image = m_seen.image.linear.template cast<Real>();
        const RealVector<Dim> centre = m_seen.image.translation.template cast<Real>();
        const RealVector<Dim> x = image * y.value + centre;
        const RealVector<Dim> error =
            image.cwiseAbs() * y.error +
            (Dim + 1) * unit * (image.cwiseAbs() * y.value.cwiseAbs() + centre.cwiseAbs());
        Mean<Dim> result{x.template cast<double>()};
        const RealVector<Dim> rounding = (result.point.template cast<Real>() - x).cwiseAbs();
        result.error = above((error + rounding).norm());
        return result;
    }

    static constexpr int size = symmetricSize<Dim>;

    // Upper triangle of the covariance in the coordinates of m_seen, given the mean.
    std::optional<Solution<size>> covariance(const Solution<Dim>& mean) const {
        RealMatrix<size> transfer = RealMatrix<size>::Zero(), transferError = transfer;
        RealVector<size> source = RealVector<size>::Zero(), sourceError = source;
        const Real off = m_seen.linearRounding;
        for (std::size_t i = 0; i < m_shares.size(); ++i) {
            const RealMatrix<Dim> linear = linearPart(i);
            const Real longest = linear.cwiseAbs().maxCoeff();
            const RealMatrix<size> square = m_shares[i] * squareOf(linear);
            transfer += square;
            transferError += shareUnit * square.cwiseAbs();
            transferError.array() +=
                m_shares[i] * 2 * Dim * (off * (2 * longest + off) + 8 * unit * longest * longest);
            const RealVector<Dim> way = linear * mean.value + translation(i) - mean.value;
            const RealVector<Dim> terms =
                linear.cwiseAbs() * mean.value.cwiseAbs() + translation(i).cwiseAbs() + mean.value.cwiseAbs();
            RealVector<Dim> wayError = linear.cwiseAbs() * mean.error + mean.error + (Dim + 3) * unit * terms;
            wayError.array() += off * (mean.value + mean.error).norm() + Real(m_seen.translationRounding);
            for (int row = 0, k = 0; row < Dim; ++row)
                for (int column = row; column < Dim; ++column, ++k) {
                    source[k] += m_shares[i] * way[row] * way[column];
                    sourceError[k] +=
                        m_shares[i] *
                        (std::abs(way[row]) * wayError[column] + std::abs(way[column]) * wayError[row] +
                         wayError[row] * wayError[column] +
                         (shareUnit + 4 * unit) * std::abs(way[row] * way[column]));
                }
        }
        transferError.array() += size * unit * transfer.cwiseAbs().maxCoeff();
        const auto equations = Equations<size>::of(transfer, transferError);
        if (!equations || !isContracting(*equations)) return std::nullopt;
        return equations->solve(source, sourceError);
    }

    Matrix<Dim> placed(const Solution<size>& upper, double& error) const {
        const RealMatrix<Dim> image = m_seen.image.linear.template cast<Real>();
        const RealMatrix<Dim> there = symmetric(upper.value), thereError = symmetric(upper.error);
        const RealMatrix<Dim> here = image * there * image.transpose(), stretch = image.cwiseAbs();
        const RealMatrix<Dim> hereError =
            stretch * (thereError + 2 * Dim * unit * there.cwiseAbs()) * stretch.transpose();
        Matrix<Dim> result = here.template cast<double>();
        result = (result + result.transpose()).eval() / 2;
        const RealMatrix<Dim> rounding = (result.template cast<Real>() - here).cwiseAbs();
        error = above((hereError + rounding).maxCoeff());
        return result;
    }

    // (I − M̄)⁻¹C in coordinates x.
    Matrix<Dim> correlated(const Solution<size>& upper) const {
        RealMatrix<Dim> linear = RealMatrix<Dim>::Zero();
        for (std::size_t i = 0; i < m_shares.size(); ++i)
            linear += m_shares[i] * linearPart(i);
        const RealMatrix<Dim> image = m_seen.image.linear.template cast<Real>();
        const RealMatrix<Dim> there =
            inverseOf<Dim>(RealMatrix<Dim>::Identity() - linear) * symmetric(upper.value);
        return (image * there * image.transpose()).template cast<double>();
    }

private:
    RealMatrix<Dim> linearPart(std::size_t i) const { return m_seen.maps[i].linear.template cast<Real>(); }
    RealVector<Dim> translation(std::size_t i) const {
        return m_seen.maps[i].translation.template cast<Real>();
    }

    static RealMatrix<Dim> symmetric(const RealVector<size>& upper) {
        RealMatrix<Dim> result;
        for (int i = 0, k = 0; i < Dim; ++i)
            for (int j = i; j < Dim; ++j, ++k)
                result(i, j) = result(j, i) = upper[k];
        return result;
    }

    // X ↦ A X Aᵀ on upper triangles.
    static RealMatrix<size> squareOf(const RealMatrix<Dim>& linear) {
        RealMatrix<size> result;
        for (int column = 0; column < size; ++column) {
            const RealMatrix<Dim> image =
                linear * symmetric(RealVector<size>::Unit(column)) * linear.transpose();
            for (int i = 0, k = 0; i < Dim; ++i)
                for (int j = i; j < Dim; ++j, ++k)
                    result(k, column) = image(i, j);
        }
        return result;
    }

    // A map of the positive matrices into themselves has ρ < 1 if and only if a positive definite X exceeds
    // its image by the identity.
    static bool isContracting(const Equations<size>& equations) {
        RealVector<size> identity;
        for (int i = 0, k = 0; i < Dim; ++i)
            for (int j = i; j < Dim; ++j, ++k)
                identity[k] = i == j ? 1 : 0;
        const auto form = equations.solve(identity, RealVector<size>::Zero());
        const RealMatrix<Dim> value = symmetric(form.value), error = symmetric(form.error);
        if (!value.allFinite() || !(value.diagonal().minCoeff() > 0)) return false;
        // Scaled to a unit diagonal, so that a slow direction does not hide the others.
        const auto scale = value.diagonal().cwiseSqrt().cwiseInverse().asDiagonal();
        const RealMatrix<Dim> scaled = scale * value * scale, scaledError = scale * error * scale;
        return leastSymmetricEigenvalue(scaled) > scaledError.norm() + 64 * unit;
    }

    Conditioned<Dim> m_seen;
    std::vector<Real> m_shares;
};

template <int Dim> bool areFinite(const ActiveMaps<Dim>& active) {
    return !active.maps.empty() && std::ranges::all_of(active.maps, isFinite<Dim>);
}

} // namespace

template <int Dim> std::optional<Mean<Dim>> mean(const ActiveMaps<Dim>& active) {
    if (!areFinite(active)) return std::nullopt;
    const MomentsOf<Dim> moments(active);
    const auto found = moments.mean();
    if (!found) return std::nullopt;
    const Mean<Dim> result = moments.placed(*found);
    return result.point.allFinite() && std::isfinite(result.error) ? std::optional(result) : std::nullopt;
}

template <int Dim> std::optional<Mean<Dim>> enclosedFixedPoint(const AffineMap<Dim>& map) {
    if (!isFinite(map)) return std::nullopt;
    const auto equations = Equations<Dim>::of(map.linear.template cast<Real>(), RealMatrix<Dim>::Zero());
    if (!equations) return std::nullopt;
    const auto found = equations->solve(map.translation.template cast<Real>(), RealVector<Dim>::Zero());
    Mean<Dim> result{found.value.template cast<double>()};
    const RealVector<Dim> rounding = (result.point.template cast<Real>() - found.value).cwiseAbs();
    result.error = above((found.error + rounding).norm());
    return result.point.allFinite() && std::isfinite(result.error) ? std::optional(result) : std::nullopt;
}

template <int Dim> std::optional<Moments<Dim>> moments(const ActiveMaps<Dim>& active) {
    if (!areFinite(active)) return std::nullopt;
    const MomentsOf<Dim> there(active);
    const auto mean = there.mean();
    const auto covariance = mean ? there.covariance(*mean) : std::nullopt;
    if (!covariance) return std::nullopt;
    Moments<Dim> result;
    const Mean<Dim> placed = there.placed(*mean);
    result.mean = placed.point;
    result.meanError = placed.error;
    result.covariance = there.placed(*covariance, result.covarianceError);
    const Matrix<Dim> oneSided = there.correlated(*covariance);
    result.longRunCovariance = oneSided + oneSided.transpose() - result.covariance;
    const bool isFinite = result.mean.allFinite() && result.longRunCovariance.allFinite() &&
                          std::isfinite(result.meanError) && std::isfinite(result.covarianceError);
    return isFinite ? std::optional(result) : std::nullopt;
}

template std::optional<Mean<2>> mean(const ActiveMaps<2>&);
template std::optional<Mean<3>> mean(const ActiveMaps<3>&);
template std::optional<Mean<2>> enclosedFixedPoint(const AffineMap<2>&);
template std::optional<Mean<3>> enclosedFixedPoint(const AffineMap<3>&);
template std::optional<Moments<2>> moments(const ActiveMaps<2>&);
template std::optional<Moments<3>> moments(const ActiveMaps<3>&);

} // namespace ifs
