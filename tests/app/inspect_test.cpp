#include <catch2/catch.hpp>

#include <cmath>

#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"
#include "tests/support/reference_phi.hpp"
#include "tests/support/typed_door.hpp"

/// The JSON of `inspect` has enough in it to compute every number again: here Φ, in long double and from the
/// JSON alone, and Φq from differences of that Φ.
namespace jw::test {
namespace {

using nlohmann::json;
using reference::M3;
using reference::Real;
using reference::V3;
using reference::V4;

V3 vector_in(const json& list) {
    return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

struct PrintedBody {
    V3 r;
    V4 p;
    M3 A;
};

/// Equations of one entry of "constraints", the dropped one included.
std::vector<Real> equations_of(const json& c, const PrintedBody& i, const PrintedBody& j, Real theta) {
    const json& data = c["data"];
    const auto arm = [&](const PrintedBody& b, const char* key) { return V3(b.A * vector_in(data[key])); };
    const auto between = [&](const char* from, const char* to) {
        return V3(j.r + arm(j, to) - i.r - arm(i, from));
    };
    const auto three = [](const V3& v) { return std::vector<Real>{v.x(), v.y(), v.z()}; };
    const std::string primitive = c["primitive"];
    if (primitive == "s") { return three(-between("P_i_local", "P_j_local")); }
    if (primitive == "n1") { return {arm(i, "s_i_local").dot(arm(j, "s_j_local"))}; }
    if (primitive == "n2") { return {arm(i, "s_i_local").dot(between("B_i_local", "B_j_local"))}; }
    if (primitive == "p1") { return three(arm(i, "s_i_local").cross(arm(j, "s_j_local"))); }
    if (primitive == "p2") { return three(arm(i, "s_i_local").cross(between("B_i_local", "B_j_local"))); }
    if (primitive == "n1 pair") {
        return {arm(i, "a_i_local").dot(arm(j, "s_j_local")), arm(i, "b_i_local").dot(arm(j, "s_j_local"))};
    }
    if (primitive == "n2 pair") {
        const V3 d = between("B_i_local", "B_j_local");
        return {arm(i, "a_i_local").dot(d), arm(i, "b_i_local").dot(d)};
    }
    if (primitive == "d") {
        const V3 d = between("P_i_local", "P_j_local");
        const Real length = data["length"].get<double>();
        return {d.dot(d) - length * length};
    }
    const V3 s = arm(i, "s_i_local");
    if (primitive == "r") {
        return {
            s.dot(between("B_i_local", "B_j_local")) - Real(data["d_0"].get<double>()) -
            Real(data["alpha"].get<double>()) * (theta - Real(data["theta_0"].get<double>()))};
    }
    REQUIRE(primitive == "θ");
    const V3 u_i = arm(i, "u_i_local");
    const V3 u_j = arm(j, "u_j_local");
    const Real sine = u_i.cross(u_j).dot(s);
    const Real cosine = u_i.dot(u_j);
    const std::string form = data["form"];
    if (form == "cosine") { return {cosine - std::cos(theta)}; }
    if (form == "sine") { return {sine - std::sin(theta)}; }
    return {sine * std::cos(theta) - cosine * std::sin(theta)};
}

/// Φ of all constraints (no drivers in these scenes) with `shift` added to one unknown of one body:
/// 0..2 of r, 3..6 of p.
std::vector<Real> phi_of(
    const json& inspection, bool homogeneous, const std::string& moved, int k, Real shift) {
    std::map<std::string, PrintedBody> bodies;
    for (const json& b : inspection["bodies"]) {
        PrintedBody body;
        body.r = vector_in(b["r"]);
        for (int e = 0; e < 4; ++e) { body.p(e) = b["p"][static_cast<std::size_t>(e)].get<double>(); }
        if (b["name"] == moved) { (k < 3 ? body.r(k) : body.p(k - 3)) += shift; }
        body.A = reference::rotation(body.p, homogeneous);
        bodies[b["name"]] = body;
    }
    std::map<std::string, Real> thetas;
    for (const json& a : inspection["artificial_coordinates"]) {
        thetas[a["joint"]] = a["theta"].get<double>();
    }
    std::vector<Real> phi;
    for (const json& c : inspection["constraints"]) {
        const std::vector<Real> all =
            equations_of(c, bodies.at(c["body_i"]), bodies.at(c["body_j"]), thetas[c["joint"]]);
        for (std::size_t e = 0; e < all.size(); ++e) {
            const bool dropped = c["dropped"].is_string() && c["dropped"] == std::string(1, "xyz"[e]);
            if (!dropped) { phi.push_back(all[e]); }
        }
    }
    return phi;
}

/// A scene of every joint, far from assembled.
std::string scene_of_all_joints() {
    std::string text = "format = 1\ntitle = \"all\"\n";
    const char* names[] = {"a", "b", "c"};
    for (int k = 0; k < 3; ++k) {
        text += "[[body]]\nname = \"" + std::string(names[k]) + "\"\nposition = [0." + std::to_string(k + 1) +
                ", -0.4, 0." + std::to_string(7 - k) + "]\nrotation = { axis = [1, " + std::to_string(k) +
                ", -0.5], angle_deg = " + std::to_string(40 + 50 * k) +
                " }\nvelocity = [0.3, -0.1, 0.2]\nomega_local_rad_per_s = [0.5, 1, -0.7]\n";
    }
    const std::string points = "point_i = [0.1, 0.2, 0.3]\npoint_j = [-0.2, 0.1, 0.4]\n";
    const std::string axes = "axis_i = [1, 2, -1]\naxis_j = [0.5, 1.5, -1]\n";
    const auto joint = [&](const std::string& name, const std::string& i, const std::string& j,
                           const std::string& rest) {
        text += "[[joint]]\nname = \"" + name + "\"\ntype = \"" + name + "\"\nbodies = [\"" + i + "\", \"" +
                j + "\"]\n" + rest;
    };
    joint("spherical", "a", "b", points);
    joint("universal", "ground", "a", points + axes);
    joint("revolute", "b", "c", points + axes);
    joint("cylindrical", "a", "c", points + axes + "parallel = \"pair\"\n");
    joint(
        "prismatic", "c", "ground",
        points + axes + "side_i = [2, -1, 0]\nside_j = [3, -1, 0]\nparallel = \"all three\"\n");
    joint("screw", "a", "b", points + axes + "pitch = 0.2\ntheta_deg = 200\nangle_row = \"sine\"\n");
    joint("fixed", "b", "ground", points + axes);
    joint("planar", "a", "c", points + axes + "parallel = \"drop y\"\n");
    joint("distance", "b", "c", points + "length = 0.8\n");
    return text;
}

json inspected(const std::string& file, const std::string& coordinates) {
    const Ran ran = run({"inspect", file, "--as-given", "--coordinates", coordinates, "--format", "json"});
    INFO(ran.err);
    REQUIRE(ran.status == 0);
    return json::parse(ran.out);
}

}  // namespace

TEST_CASE("Φ and Φq follow from the JSON alone, for every joint", "[app][inspect]") {
    const Folder folder;
    const std::string file = folder.file("all.toml", scene_of_all_joints());
    for (const bool homogeneous : {false, true}) {
        const json j = inspected(file, homogeneous ? "rp-modified" : "rp");
        CHECK(j["version"] == 1);
        const std::vector<Real> phi = phi_of(j, homogeneous, "", 0, 0);
        const std::size_t bodies = 3;
        REQUIRE(j["phi"].size() == phi.size() + bodies);
        for (std::size_t row = 0; row < phi.size(); ++row) {
            INFO(j["rows"][row]["label"]);
            // sums of a few products of size 1 in double
            CHECK(std::abs(j["phi"][row].get<double>() - static_cast<double>(phi[row])) < 2e-15);
        }
        for (std::size_t column = 0; column < 21; ++column) {
            const std::string owner = j["columns"][column]["owner"];
            const int k = static_cast<int>(column % 7);
            // central differences in long double of at most fourth powers of p: some 100 h² / 6, and 1e-19 /
            // h
            const Real h = 1e-7L;
            const std::vector<Real> plus = phi_of(j, homogeneous, owner, k, h);
            const std::vector<Real> minus = phi_of(j, homogeneous, owner, k, -h);
            for (std::size_t row = 0; row < phi.size(); ++row) {
                INFO(j["rows"][row]["label"] << ", " << owner << " " << j["columns"][column]["coordinate"]);
                const double difference = static_cast<double>((plus[row] - minus[row]) / (2 * h));
                CHECK(std::abs(j["jacobian"][row][column].get<double>() - difference) < 1e-11);
            }
        }
    }
}

TEST_CASE("the four coordinate choices tell the same velocity of Φ and the same rank", "[app][inspect]") {
    const Folder folder;
    const std::string file = folder.file("all.toml", scene_of_all_joints());
    const json reference = inspected(file, "omega-local");
    const auto rate_of = [](const json& j) {
        std::vector<double> rates;
        std::map<std::string, json> bodies;
        for (const json& b : j["bodies"]) { bodies[b["name"]] = b; }
        for (std::size_t row = 0; row < j["rows"].size(); ++row) {
            double rate = 0.0;
            for (std::size_t column = 0; column < j["columns"].size(); ++column) {
                const std::string name = j["columns"][column]["coordinate"];
                const std::string owner = j["columns"][column]["owner"];
                double velocity = 0.0;
                const std::size_t axis = name.size() == 1 ? std::string("xyz").find(name) : 0;
                if (name == "theta") {
                    velocity = j["artificial_coordinates"][0]["theta_dot"].get<double>();
                } else if (name.size() == 1) {
                    velocity = bodies[owner]["r_dot"][axis].get<double>();
                } else if (name[0] == 'e') {
                    velocity = bodies[owner]["p_dot"][static_cast<std::size_t>(name[1] - '0')].get<double>();
                } else {
                    const char* key = name.starts_with("omega_local") ? "omega_local" : "omega_global";
                    velocity = bodies[owner][key][std::string("xyz").find(name.back())].get<double>();
                }
                rate += j["jacobian"][row][column].get<double>() * velocity;
            }
            rates.push_back(rate);
        }
        return rates;
    };
    const std::vector<double> expected = rate_of(reference);
    for (const std::string choice : {"rp", "rp-modified", "omega-global"}) {
        const json j = inspected(file, choice);
        const std::vector<double> rates = rate_of(j);
        for (std::size_t row = 0; row < expected.size(); ++row) {
            INFO(choice << " " << j["rows"][row]["label"]);
            // p typed as axis and angle is unit to rounding, and so is pᵀṗ
            CHECK(std::abs(rates[row] - expected[row]) < 1e-14 * 10);
        }
        CHECK(j["rank"] == reference["rank"]);
    }
}

TEST_CASE("inspect says how far its numbers can be off", "[app][inspect]") {
    const Ran ran = run({"inspect", lesson_path("loops/four-bar.toml"), "--time", "0.5", "--format", "json"});
    REQUIRE(ran.status == 0);
    const json j = json::parse(ran.out);
    CHECK(j["singular_values_sound"] == true);
    CHECK(j["singular_value_error"] < 1e-12);  // n² roundings
    for (const char* key : {"position_residual", "velocity_residual"}) {
        CAPTURE(key);
        CHECK(j[key]["value"] <= j[key]["bound"]);
        CHECK(j[key]["bound"] < 1e-10);
    }
    const json& rank = j["rank"];
    CHECK(rank["decided"] == true);
    CHECK(rank["doubts"].empty());
    CHECK(rank["singular_value_error"] < 1e-12);
    CHECK(rank["pose_error"] < 1e-9);
    REQUIRE(rank["redundant_rows"].size() > 0);
    for (const json& row : rank["redundant_rows"]) { CHECK(row["misfit"] <= row["bound"]); }
    for (const json& motion : rank["free_motions"]) { CHECK(motion["residual"] <= motion["bound"]); }
}

TEST_CASE("step, inspect and try have one verdict on each free motion", "[app][inspect]") {
    const auto told_by = [](std::vector<std::string> command) {
        const Ran ran = run(command);
        REQUIRE(ran.status == 0);
        return json::parse(ran.out);
    };
    for (const char* name : {"hard/two-ways-on", "hard/cosine-row", "loops/bennett"}) {
        CAPTURE(name);
        const std::string file = lesson_path(name + std::string(".toml"));
        const std::vector<std::string> undriven =
            std::string(name) == "hard/two-ways-on"
                ? std::vector<std::string>{"--try", "take out motor", "--format", "json"}
                : std::vector<std::string>{"--format", "json"};
        const auto with = [&](std::vector<std::string> command) {
            command.insert(command.begin() + 1, file);
            command.insert(command.end(), undriven.begin(), undriven.end());
            return told_by(command);
        };
        json last;
        const json steps = with({"step"})["steps"];
        for (const json& step : steps) {
            const json& judgements = step["rank"]["free_motion_judgements"];
            const bool lists_them = step["kind"] == "assembled" || step["kind"] == "answer";
            if (!lists_them) { CHECK(judgements.is_null()); }
            if (step["kind"] == "assembled") { last = judgements; }
        }
        const json tried = with({"try"})["free_motions"];
        const json inspected = with({"inspect"})["rank"]["free_motions"];
        CHECK(inspected.size() == tried.size());
        CHECK((last.is_null() ? 0 : last.size()) == tried.size());
        for (std::size_t k = 0; k < tried.size(); ++k) {
            CHECK(inspected[k]["judgement"] == last[k]);
            for (const char* key : {"verdict", "motion_beside", "departure"}) {
                CHECK(last[k][key] == tried[k][key]);
            }
        }
    }
    const Ran told = run({"inspect", lesson_path("hard/two-ways-on.toml")});
    CHECK_THAT(
        told.out, Catch::Contains("to first order only · coupler: ω′y 0.5; rocker: ω′y 1; violates D by"));
    // the matrix of a pose that is not assembled says nothing about motions
    const json given = told_by({"inspect", lesson_path("loops/rssr.toml"), "--as-given", "--format", "json"});
    REQUIRE(given["rank"]["free_motions"].size() == 1);
    for (const json& motion : given["rank"]["free_motions"]) { CHECK(motion["judgement"].is_null()); }
}

TEST_CASE("So many free motions that a reader would wait are listed without verdicts", "[app][inspect]") {
    const Folder folder;
    for (const int bodies : {12, 13}) {
        std::string chain = "format = 1\ntitle = \"A chain\"\n";
        for (int k = 1; k <= bodies; ++k) { chain += "[[body]]\nname = \"" + std::to_string(k) + "\"\n"; }
        for (int k = 1; k <= bodies; ++k) {
            chain += "[[joint]]\nname = \"J" + std::to_string(k) + "\"\ntype = \"revolute\"\nbodies = [\"" +
                     (k == 1 ? "ground" : std::to_string(k - 1)) + "\", \"" + std::to_string(k) +
                     "\"]\nat = [" + std::to_string(k) + ", 0, 0]\naxis = [0, 0, 1]\n";
        }
        const Ran ran = run({"inspect", folder.file("chain.toml", chain), "--format", "json"});
        const json rank = json::parse(ran.out)["rank"];
        REQUIRE(rank["free_motions"].size() == static_cast<std::size_t>(bodies));
        // 12 of 72 columns, 13 of 78: less than 1000 entries, and more
        for (const json& motion : rank["free_motions"]) {
            CHECK(motion["judgement"].is_null() == (bodies == 13));
        }
    }
}

TEST_CASE("JSON tells what typed digits leave open about the rank", "[app][inspect]") {
    const std::string door = test::typed_door();
    const Folder folder;
    const auto ranks = [&](const std::string& text) {
        const std::string file = folder.file("door.toml", text);
        const json told = json::parse(run({"step", file, "--format", "json"}).out);
        json list = json::array();
        list.push_back(json::parse(run({"inspect", file, "--format", "json"}).out)["rank"]);
        for (const json& step : told["steps"]) { list.push_back(step["rank"]); }
        return list;
    };
    const json typed = ranks(door);
    for (const json& rank : {typed.front(), typed.back()}) {
        const json& digits = rank["typed_digits"];
        CHECK(digits["verdict"] == "meant");
        CHECK(digits["rank_as_typed"] == 6);
        CHECK(digits["rank"] == 5);
        CHECK(rank["rank"] == 5);
        CHECK(digits["share"] > 0.0);
        CHECK(digits["share"] <= 1.0);
        CHECK(digits["misfit"] > 0.0);
    }
    // the first joint alone has no redundant row
    CHECK(typed[1]["typed_digits"].is_null());
    // both axes have as few digits
    CHECK(typed.back()["typed_digits"]["short_of_digits"].is_null());
    const std::string few = "[0.21822, 0.43644, 0.87287]";
    const std::string many = "[0.2182178902359924, 0.4364357804719848, 0.8728715609439696]";
    const json one_axis = ranks(std::string(door).replace(door.find(few), few.size(), many));
    CHECK(one_axis.back()["typed_digits"]["short_of_digits"] == "'axis' of revolute joint 'upper'");
    for (const json& rank : ranks(door + "[precision]\nexact = true\n")) {
        CHECK(rank["typed_digits"].is_null());
    }
}

TEST_CASE("text of inspect labels every row and every column", "[app][inspect]") {
    const Folder folder;
    const std::string file = folder.file("crank.toml", kCrank);
    const Ran ran = run({"inspect", file, "--coordinates", "omega-local", "--time", "0.5"});
    CHECK(ran.status == 0);
    INFO(ran.out);
    for (const char* text :
         {"pivot · s · x", "pivot · p1 · y", "drive", "Φq, columns of crank", "ω′z", "rank 6 of 6 equations",
          "The z equation is left out"}) {
        CHECK(ran.out.find(text) != std::string::npos);
    }
}

TEST_CASE("inspect counts the equations of p1 that are kept after some are taken out", "[app][inspect]") {
    struct Case {
        const char* form;
        const char* without;
        const char* said;
    };
    const Folder folder;
    for (const Case& c :
         {Case{"all three", "\"p1 x\"", "takes out the equation x: two are kept, y and z"},
          Case{"all three", "\"p1 x\", \"p1 y\"", "takes out the equations x and y: one is kept, z"},
          Case{"pair", "\"n1 pair a\"", "takes out the equation a: one is kept, b"},
          Case{"rule", "\"p1 y\"", "takes out the equation y, and x is left out as well: one is kept, z"}}) {
        CAPTURE(c.form, c.without);
        const std::string file = folder.file(
            "hinge.toml",
            std::string(
                "format = 1\ntitle = \"t\"\n[[body]]\nname = \"b\"\n[[joint]]\nname = \"K\"\n"
                "type = \"revolute\"\nbodies = [\"ground\", \"b\"]\nat = [0, 1, 0]\naxis = [1, 0, 0]\n"
                "parallel = \"") +
                c.form + "\"\nwithout = [" + c.without + "]\n");
        const Ran ran = run({"inspect", file, "--format", "json"});
        INFO(ran.err);
        REQUIRE(ran.status == 0);
        const std::string reason = nlohmann::json::parse(ran.out)["choices"][0]["reason"];
        INFO(reason);
        CHECK(reason.find(c.said) != std::string::npos);
    }
}

}  // namespace jw::test
