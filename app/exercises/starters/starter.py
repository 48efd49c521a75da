import json
import sys


def answer(case):
    NAME = case["NAME"]
    return 0  # a number, a list, or a list of rows


data = json.load(sys.stdin)
print(json.dumps({"answers": [answer(case) for case in data["cases"]]}))
