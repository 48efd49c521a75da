#include <catch2/catch.hpp>

#include "tests/architecture/include_rules.hpp"
#include "tests/architecture/project_tree.hpp"

namespace jw::architecture {

TEST_CASE("Every include goes down the order of the folders", "[architecture]") {
    int includes_count = 0;
    for (const SourceFile& file : project_files()) {
        if (!is_cpp(file)) { continue; }
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const auto name = included_by(file.lines[i]);
            if (!name) { continue; }
            ++includes_count;
            if (const auto reason = objection(file.path, *name)) {
                FAIL_CHECK(file.path << ':' << i + 1 << ": " << *reason);
            }
        }
    }
    CHECK(includes_count > 0);  // with a wrong root no line would be checked
}

TEST_CASE("Includes against the order of the folders are objected to", "[architecture]") {
    CHECK(objection("core/poses/rank.cpp", "lessons/lesson/lesson.hpp"));
    CHECK(objection("core/poses/rank.cpp", "toml++/toml.h"));
    CHECK(objection("core/poses/rank.cpp", "Eigen/SVD"));
    CHECK(objection("core/poses/rank.cpp", "core/motion/loads.hpp"));
    CHECK(objection("core/motion/certificate.cpp", "core/motion/tree/tree_equations.hpp"));
    CHECK(objection("core/rank.cpp", "core/poses/rank.hpp"));
    CHECK(objection("lessons/read/reader.cpp", "app/session/story/story.hpp"));
    CHECK(objection("render/passes/scene_renderer.cpp", "core/model/mechanism.hpp"));
    CHECK(objection("render/passes/scene_renderer.cpp", "GL/osmesa.h"));
    CHECK(objection("app/session/story/story.cpp", "render/passes/scene_renderer.hpp"));
    CHECK(objection("app/session/story/story.cpp", "imgui.h"));
    CHECK(objection("app/session/story/story.cpp", "app/session/view/view.hpp"));
    CHECK(objection("app/session/output/json.cpp", "app/session/try/session.hpp"));
    CHECK(objection("app/session/story.cpp", "app/session/view/view.hpp"));
    CHECK(objection("app/panels/parts/text_lines.cpp", "app/panels/frame/frame.hpp"));
    CHECK(objection("app/panels/rows_panel.cpp", "GL/gl.h"));
    CHECK(objection("app/panels/rows_panel.cpp", "GLFW/glfw3.h"));
    CHECK(objection("app/commands/render.cpp", "GL/osmesa.h"));
}

TEST_CASE("Includes in the order of the folders are not objected to", "[architecture]") {
    CHECK_FALSE(objection("core/poses/rank.cpp", "Eigen/QR"));
    CHECK_FALSE(objection("core/motion/tree/tree_equations.cpp", "core/motion/forces.hpp"));
    CHECK_FALSE(objection("lessons/read/reader.cpp", "core/model/mechanism.hpp"));
    CHECK_FALSE(objection("lessons/fields/toml_text.cpp", "toml++/toml.h"));
    CHECK_FALSE(objection("app/session/story/story.cpp", "render/scene/scene.hpp"));
    CHECK_FALSE(objection("app/commands/render.cpp", "render/surface/offscreen.hpp"));
    CHECK_FALSE(objection("core/poses/rank.cpp", "vector"));
}

TEST_CASE("The name of an include is read from its line", "[architecture]") {
    CHECK(included_by("#include \"core/poses/rank.hpp\"") == "core/poses/rank.hpp");
    CHECK(included_by("  # include <vector>  // why") == "vector");
    CHECK_FALSE(included_by("// #include <vector>"));
}

}  // namespace jw::architecture
