#pragma once

#include <memory>
#include <vector>

#include "core/equations/measure_jet.hpp"
#include "core/integrate/reduced_coordinates.hpp"
#include "core/kinematics/motion_tracker.hpp"

/// Independent coordinates, as many as there are freedoms: angles and displacements of joints, or coordinates
/// of bodies where joints do not suffice. All others follow from the constraints, so nothing can drift.
namespace jw {

/// Independent coordinate: a measure between two bodies.
struct IndependentCoordinate {
    Measure measure;
    int body_i = 0;
    int body_j = 0;
};

/// State x = (z, ż) with z the independent coordinates; places a mechanism at given x and computes ẋ there.
/// If the drivers leave no freedom, x is empty and poses come from the motion tracker, since Newton's method
/// from an estimate may lead to another branch.
/// @source coordinate partitioning, book ch. 13
class IndependentCoordinates final : public ReducedCoordinates {
public:
    /// `centroidal` and `equations` must outlive this.
    IndependentCoordinates(const Centroidal& centroidal, DrivableEquations& equations);

    /// Chooses rows and coordinates at y, those of joints first. @return x there
    VectorX choose(double t, const double* y) override;
    /// True if the choice still distinguishes the freedoms at the last evaluation, and the kept rows are
    /// still sound.
    bool is_sound() const override;

    double pivot_left() const override;
    double pivot_with_coordinates_left() const override;
    RowsVerdict verdict() const override { return verdict_; }

    /// Moves y, an estimate, to the state with coordinates x, and computes ẏ and ẋ.
    void evaluate(double t, const VectorX& x, double* y, double* y_dot, Eigen::Ref<VectorX> x_dot) override;
    void follow_turns(double t, const double* y) override;
    /// Scales of x: the extent of the scene for lengths, 1 for everything else; for their rates, these times
    /// the fastest motion so far.
    VectorX sizes(const StateScales& scales) const override;

private:
    MeasureJet jet_at(const IndependentCoordinate& coordinate, const double* y) const;
    /// Gradients, one row each, six numbers per moving body.
    MatrixX gradients(const std::vector<IndependentCoordinate>& of, const double* y) const;
    void drive(double t, const VectorX& x);
    void begin_tracking(double t, const double* y);
    void place(double t, const VectorX& x, double* y);
    void accept(double t, const double* y);
    /// Derivative of a coordinate along the six rates per body in `y_dot`.
    double along(const IndependentCoordinate& coordinate, const MeasureJet& jet, const double* y_dot) const;
    int order_of(int body) const { return order_of_body_[static_cast<std::size_t>(body)]; }

    const Centroidal* scene_;
    DrivableEquations* equations_;
    std::vector<int> order_of_body_;
    std::vector<IndependentCoordinate> of_joints_;
    std::vector<IndependentCoordinate> of_bodies_;
    std::vector<IndependentCoordinate> chosen_;
    double pivot_of_rows_ = 1.0;  ///< pivot of the equations without the coordinates' drivers, at the choice
    double best_pivot_of_rows_ = 0.0;  ///< largest of all choices so far
    RowsVerdict verdict_;              ///< verdict of the last evaluation
    double sharpness_ = 1.0;           ///< smallest sharpness of a coordinate at the last evaluation
    Centroidal driven_scene_;          ///< scene with a driver for every chosen coordinate
    std::unique_ptr<DrivableEquations> driven_;
    std::vector<int> moving_;
    std::unique_ptr<System> system_;          ///< empty if the mechanism has freedoms
    std::unique_ptr<MotionTracker> tracker_;  ///< of `system_`; proves poses, however small pivots are
    double accepted_t_ = 0.0;
    std::vector<double> accepted_;  ///< y at the end of the last step
};

}  // namespace jw
