"""What readers of JUnit, Gradescope and PrairieLearn need, as checks: each raises AssertionError with what is wrong."""

import xml.etree.ElementTree


def check_junit(text):
    """As Jenkins, GitHub and GitLab read it: testsuites > testsuite > testcase > nothing or one verdict, and counts that agree.

    @return the names of all test cases
    """
    root = xml.etree.ElementTree.fromstring(text)
    assert root.tag == "testsuites" and set(root.attrib) <= {"name", "tests", "failures", "errors", "skipped"}, root.attrib
    verdicts = {"failures": "failure", "errors": "error", "skipped": "skipped"}
    sums = dict.fromkeys(("tests", *verdicts), 0)
    for suite in root:
        assert suite.tag == "testsuite" and suite.get("name"), suite.attrib
        assert set(suite.attrib) == {"name", "tests", *verdicts}, suite.attrib
        assert int(suite.get("tests")) == len(suite)
        known = set()
        for case in suite:
            assert case.tag == "testcase" and set(case.attrib) == {"classname", "name"} and all(case.attrib.values()), case.attrib
            assert (case.get("classname"), case.get("name")) not in known, f"two cases are called {case.get('name')}"
            known.add((case.get("classname"), case.get("name")))
            assert len(case) <= 1 and all(verdict.tag in verdicts.values() for verdict in case)
            for verdict in case:
                assert verdict.get("message"), "a verdict has no message"
                assert verdict.tag == "skipped" or verdict.get("type"), "a failure has no type"
        for attribute, tag in verdicts.items():
            assert int(suite.get(attribute)) == len(suite.findall(f"testcase/{tag}")), f"{attribute} of {suite.get('name')}"
            sums[attribute] += int(suite.get(attribute))
        sums["tests"] += len(suite)
    for attribute, number in sums.items():
        assert int(root.get(attribute, number)) == number, f"{attribute} in all"
    return [case.get("name") for case in root.iter("testcase")]


def is_number(value): return isinstance(value, (int, float)) and not isinstance(value, bool)


def check_gradescope(results):
    """The specification of results.json: https://gradescope-autograders.readthedocs.io/en/latest/specs/"""
    known = {"score", "execution_time", "output", "output_format", "test_output_format", "test_name_format", "visibility",
             "stdout_visibility", "extra_data", "tests", "leaderboard"}
    of_test = {"score", "max_score", "status", "name", "name_format", "number", "output", "output_format", "tags", "visibility",
               "extra_data"}
    assert set(results) <= known, set(results) - known
    assert is_number(results["score"]) and results["tests"]
    for test in results["tests"]:
        assert set(test) <= of_test, set(test) - of_test
        assert is_number(test["score"]) and is_number(test["max_score"]) and 0 <= test["score"] <= test["max_score"], test
        assert test["name"] and isinstance(test["name"], str) and isinstance(test["output"], str)
        assert test["status"] in ("passed", "failed")
        assert (test["status"] == "passed") == (test["score"] == test["max_score"]), test
        assert test["visibility"] in ("hidden", "after_due_date", "after_published", "visible")
    assert abs(results["score"] - sum(test["score"] for test in results["tests"])) < 1e-9


def check_prairielearn(results):
    """The results of external graders: https://prairielearn.readthedocs.io/en/latest/externalGrading/"""
    known = {"gradable", "score", "message", "output", "images", "tests", "format_errors"}
    of_test = {"name", "description", "points", "max_points", "message", "output", "images"}
    assert set(results) <= known, set(results) - known
    assert results["gradable"] is True and is_number(results["score"]) and 0.0 <= results["score"] <= 1.0
    for test in results["tests"]:
        assert set(test) <= of_test, set(test) - of_test
        assert test["name"] and test["message"] and all(isinstance(test[key], str) for key in ("name", "message", "output"))
        assert is_number(test["points"]) and is_number(test["max_points"]) and 0 <= test["points"] <= test["max_points"], test
    most = sum(test["max_points"] for test in results["tests"])
    assert abs(results["score"] - sum(test["points"] for test in results["tests"]) / most) < 1e-9
