#pragma once

#include <memory>
#include <vector>

#include "core/dynamics/reduced_coordinates.hpp"
#include "core/measure_jet.hpp"

/// The motion in as many coordinates as there are freedoms: angles and displacements of joints, or
/// coordinates of bodies where joints do not say enough. All others follow from the constraints, so nothing
/// can drift.
namespace jw {

/// One of them: a measure between two bodies.
struct IndependentCoordinate {
    Measure measure;
    int body_i = 0;
    int body_j = 0;
};

/// x = (z, ż) with z the independent coordinates; places a mechanism at given x and tells ẋ there.
/// @source coordinate partitioning, book ch. 13
class IndependentCoordinates final : public ReducedCoordinates {
public:
    /// `centroidal` and `equations` must outlive this.
    IndependentCoordinates(const Centroidal& centroidal, DrivableEquations& equations);

    /// Chooses rows, and coordinates for the freedoms at y, joints first. @return x there
    VectorX choose(double t, const double* y) override;
    /// Whether the choice still tells the freedoms apart where it was evaluated last, and the rows kept of
    /// those that repeat each other are still good.
    bool is_sound() const override;

    double pivot_left() const override;
    double pivot_with_coordinates_left() const override;
    RowsVerdict verdict() const override { return verdict_; }

    /// Moves y, an estimate, to where the coordinates are x, and tells ẋ.
    void evaluate(double t, const VectorX& x, double* y, double* y_dot, Eigen::Ref<VectorX> x_dot) override;
    void follow_turns(double t, const double* y) override {
        equations_->follow_turns(t, y);
        driven_->follow_turns(t, y);
    }
    /// Lengths by the size of the scene, everything else by 1; their rates by the fastest motion so far
    /// besides.
    VectorX sizes(const StateScales& scales) const override;

private:
    MeasureJet jet_at(const IndependentCoordinate& coordinate, const double* y) const;
    /// Their gradients, rows of six numbers per moving body.
    MatrixX gradients(const std::vector<IndependentCoordinate>& of, const double* y) const;
    void drive(double t, const VectorX& x);
    /// How fast one changes when bodies move as the six rates in `y_dot` say.
    double along(const IndependentCoordinate& coordinate, const MeasureJet& jet, const double* y_dot) const;
    int order_of(int body) const { return order_of_body_[static_cast<std::size_t>(body)]; }

    const Centroidal* scene_;
    DrivableEquations* equations_;
    std::vector<int> order_of_body_;
    std::vector<IndependentCoordinate> of_joints_;
    std::vector<IndependentCoordinate> of_bodies_;
    std::vector<IndependentCoordinate> chosen_;
    double pivot_of_rows_ = 1.0;       ///< of the equations without the coordinates' drivers, at the choice
    double best_pivot_of_rows_ = 0.0;  ///< of all choices so far
    RowsVerdict verdict_;              ///< where it was evaluated last
    double sharpness_ = 1.0;           ///< of the coordinate that told least where it was evaluated last
    Centroidal driven_scene_;          ///< with a driver for every chosen coordinate
    std::unique_ptr<DrivableEquations> driven_;
};

}  // namespace jw
