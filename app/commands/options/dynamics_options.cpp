#include "app/commands/options/dynamics_options.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>

#include "app/commands/program/add_command.hpp"
#include "core/motion/tolerances.hpp"
#include "lessons/lesson/enum_words.hpp"

namespace jw {

namespace {

std::vector<std::string> coordinate_names() {
    std::vector<std::string> names = names_of(kFormulations);
    std::ranges::move(words_of(kChoices), std::back_inserter(names));
    return names;
}

/// Rejects options that the chosen method does not read, since whoever typed them expects an effect.
void refuse_what_is_not_read(const DynamicsOptions& options, const MethodName& method) {
    if (method.adaptive && options.step) {
        throw bad_option(
            "simulate",
            "--step applies to fixed-step methods; " + std::string(method.name) + " expects --tolerance");
    }
    if (!method.adaptive && options.tolerance) {
        throw bad_option(
            "simulate",
            "--tolerance applies to adaptive methods; " + std::string(method.name) + " expects --step");
    }
}

}  // namespace

void add_dynamics_options(CLI::App& command, DynamicsOptions& options) {
    add_value(
        command, "--method", options.method, "NAME",
        "euler, semi-implicit, rk4, explicit-5, explicit-8, implicit-5, implicit-9")
        ->check(CLI::IsMember(names_of(kMethods)));
    add_value(
        command, "--treatment", options.treatment, "NAME",
        "treatment of the constraints: none, baumgarte, projection, tangent")
        ->check(CLI::IsMember(names_of(kTreatments)));
    add_value(
        command, "--coordinates", options.coordinates, "NAME",
        "joints: coordinates of a tree of joints; bodies: r, p, ω' of every body, block-sparse; rp, "
        "rp-modified, omega-local, omega-global: the dense equations of the slides; default: joints where "
        "they are faster")
        ->check(CLI::IsMember(coordinate_names()));
    add_value(
        command, "--tolerance", options.tolerance, "X", "allowed error of a step, for adaptive methods");
    add_value(command, "--step", options.step, "H", "step [s], for the other methods");
}

void apply(const DynamicsOptions& options, SimulationSettings& settings) {
    if (!options.method.empty()) {
        settings.method = std::ranges::find(kMethods, options.method, &MethodName::name)->method;
    }
    if (!options.treatment.empty()) {
        settings.treatment =
            std::ranges::find(kTreatments, options.treatment, &TreatmentName::name)->treatment;
    }
    const auto formulation = std::ranges::find(kFormulations, options.coordinates, &FormulationName::name);
    if (formulation != kFormulations.end()) {
        settings.formulation = formulation->formulation;
    } else if (!options.coordinates.empty()) {
        settings.dense = *value_of(kChoices, options.coordinates);
    }
    refuse_what_is_not_read(options, entry_of(settings.method));
    if (options.tolerance) {
        if (!is_tolerance(*options.tolerance)) {
            throw bad_option("simulate", "--tolerance is out of range; " + std::string(kToleranceRange));
        }
        settings.tolerance = *options.tolerance;
    }
    if (options.step) {
        if (!std::isfinite(*options.step) || *options.step <= 0.0) {
            throw bad_option("simulate", "--step is not positive; expected a time in s");
        }
        settings.step = *options.step;
    }
}

}  // namespace jw
