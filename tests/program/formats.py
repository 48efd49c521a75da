"""Checks of the formats that JUnit, Gradescope, PrairieLearn and Moodle publish: each raises AssertionError with a message."""

import base64
import html
import json
import re
import xml.etree.ElementTree


def check_junit(text):
    """testsuites > testsuite > testcase > nothing or one verdict, and counts that agree.

    The elements and attributes are those of the schema of Jenkins: jenkinsci/xunit-plugin, junit-10.xsd. There `testsuites` has no
    `skipped`; a suite must have name, tests, failures and errors, a case a name. Of several failures of a case Jenkins keeps one.
    @return the names of all test cases
    """
    root = xml.etree.ElementTree.fromstring(text)
    assert root.tag == "testsuites" and set(root.attrib) <= {"name", "time", "tests", "failures", "errors"}, root.attrib
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
    """results.json: https://gradescope-autograders.readthedocs.io/en/latest/specs/

    All keys are optional but the score, which stands above the tests or in each of them; above, it overrides their sum.
    """
    known = {"score", "execution_time", "output", "output_format", "test_output_format", "test_name_format", "visibility",
             "stdout_visibility", "extra_data", "tests", "leaderboard"}
    of_test = {"score", "max_score", "status", "name", "name_format", "number", "output", "output_format", "tags", "visibility",
               "extra_data"}
    assert set(results) <= known, set(results) - known
    assert is_number(results["score"]) and results["tests"]
    assert isinstance(results.get("output", ""), str)
    for test in results["tests"]:
        assert set(test) <= of_test, set(test) - of_test
        assert is_number(test["score"]) and is_number(test["max_score"]) and 0 <= test["score"] <= test["max_score"], test
        assert test["name"] and isinstance(test["name"], str) and isinstance(test["output"], str)
        assert test["status"] in ("passed", "failed")
        assert (test["status"] == "passed") == (test["score"] == test["max_score"]), test
        assert test["visibility"] in ("hidden", "after_due_date", "after_published", "visible")
    assert abs(results["score"] - sum(test["score"] for test in results["tests"])) < 1e-9


def check_prairielearn(results):
    """results.json, "Grading results" of https://prairielearn.readthedocs.io/en/latest/externalGrading/

    A score from 0 to 1 unless `gradable` is false: then `format_errors` says why, and the attempt does not count. At most 1 MB.
    """
    known = {"gradable", "score", "message", "output", "images", "tests", "format_errors"}
    of_test = {"name", "description", "points", "max_points", "message", "output", "images"}
    assert set(results) <= known, set(results) - known
    assert len(json.dumps(results)) < 1_000_000
    assert isinstance(results["gradable"], bool)
    if not results["gradable"]:
        assert "score" not in results and results["format_errors"] and all(isinstance(e, str) for e in results["format_errors"])
        return
    assert is_number(results["score"]) and 0.0 <= results["score"] <= 1.0
    for test in results["tests"]:
        assert set(test) <= of_test, set(test) - of_test
        assert test["name"] and test["message"] and all(isinstance(test[key], str) for key in ("name", "message", "output"))
        assert is_number(test["points"]) and is_number(test["max_points"]) and 0 <= test["points"] <= test["max_points"], test
    most = sum(test["max_points"] for test in results["tests"])
    assert abs(results["score"] - sum(test["points"] for test in results["tests"]) / most) < 1e-9


NUMBER = r"-?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][-+]?\d+)?"


def check_gap(gap):
    """{1:NUMERICAL:=NUMBER:TOLERANCE#feedback~%0%...}: https://docs.moodle.org/en/Embedded_Answers_(Cloze)_question_type

    ~ } and # of a text stand behind a backslash, which only \\} and \\# of a feedback lose again (question/type/multianswer of Moodle);
    entities are decoded.
    """
    weight, kind, rest = re.fullmatch(r"\{(\d*):([A-Z_]+):(.*)\}", gap, re.DOTALL).groups()
    assert weight == "1" and kind == "NUMERICAL", gap
    fractions = []
    for alternative in re.split(r"(?<!\\)~", rest):
        fraction, _, _, feedback = re.fullmatch(
            rf"(=|%-?\d+(?:[.,]\d*)?%)({NUMBER}):({NUMBER})#(.*)", alternative, re.DOTALL).groups()
        fractions.append(100.0 if fraction == "=" else float(fraction.strip("%")))
        shown = html.unescape(feedback).replace("\\}", "}").replace("\\#", "#")
        assert shown and "\\" not in shown and not re.search(r"&#?\w+;", shown), feedback
    assert fractions[0] == 100.0 and not any(fractions[1:]), gap


def check_moodle_answers(question):
    """The answers of a question as its type needs them: https://docs.moodle.org/en/Moodle_XML_format"""
    kind, answers = question.get("type"), question.findall("answer")
    if kind == "cloze":
        gaps = re.findall(r"\{\d*:[A-Z_]+:.*?(?<!\\)\}", question.find("questiontext/text").text, re.DOTALL)
        assert gaps and not answers and question.find("defaultgrade") is None, "a cloze question has gaps, and their sum as its grade"
        for gap in gaps:
            check_gap(gap)
        return
    assert [answer.get("fraction") for answer in answers].count("100") >= 1 and float(question.find("defaultgrade").text) > 0
    assert all(answer.find("text").text and answer.get("fraction") in ("0", "100") for answer in answers)
    if kind == "numerical":
        assert all(re.fullmatch(NUMBER, answer.find("text").text) and float(answer.find("tolerance").text) > 0 for answer in answers)
    if kind == "multichoice":
        assert question.find("single").text in ("true", "false") and question.find("shuffleanswers").text in ("true", "false")
        assert question.find("answernumbering").text in ("none", "abc", "ABCD", "123", "iii", "IIII")
    if kind == "shortanswer":
        assert question.find("usecase").text in ("0", "1")


def check_moodle(text):
    """Questions of a quiz: https://docs.moodle.org/en/Moodle_XML_format

    Two slashes stand for one within the name of a category. A file is named, base64, and shown by @@PLUGINFILE@@.
    @return how many questions there are of each type
    """
    quiz = xml.etree.ElementTree.fromstring(text)
    assert quiz.tag == "quiz"
    counts = {}
    for question in quiz:
        kind = question.get("type")
        counts[kind] = counts.get(kind, 0) + 1
        assert question.tag == "question" and kind in ("category", "multichoice", "shortanswer", "numerical", "cloze"), kind
        if kind == "category":
            path = re.split("(?<!/)/(?!/)", question.find("category/text").text)
            assert path[:2] == ["$course$", "top"] and len(path) == 4 and all(path), path
            continue
        assert question.find("name/text").text
        for element in question.iter():
            assert element.get("format", "html") in ("html", "moodle_auto_format", "plain_text", "markdown")
        shown = re.findall('@@PLUGINFILE@@/([^"]*)', question.find("questiontext/text").text)
        files = question.findall("questiontext/file")
        assert shown == [file.get("name") for file in files]
        for file in files:
            assert file.get("encoding") == "base64" and base64.b64decode(file.text, validate=True).startswith(b"\x89PNG")
        check_moodle_answers(question)
    return counts
