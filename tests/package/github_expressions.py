# SPDX-License-Identifier: BSL-1.0
"""The expressions of GitHub's workflows, as far as Carom's use them: names, texts, ==, !=, &&, ||, !, always() and its
like. Anything else is an error, not a guess."""

import re

TOKEN = re.compile(r"\s*(?:(?P<text>'(?:[^']|'')*')|(?P<name>[A-Za-z_][\w.-]*)|(?P<sign>==|!=|&&|\|\||[!()]))")


def tokens_of(expression):
    tokens, at = [], 0
    while expression[at:].strip():
        found = TOKEN.match(expression, at)
        if not found:
            raise ValueError(f"expression that is not known here: {expression}")
        tokens.append(found)
        at = found.end()
    return tokens


class Reader:
    """Reads tokens by recursive descent."""

    def __init__(self, expression, contexts, failed):
        self.tokens = tokens_of(expression)
        self.contexts = contexts
        self.failed = failed

    def next_is(self, sign):
        if self.tokens and self.tokens[0]["sign"] == sign:
            self.tokens.pop(0)
            return True
        return False

    def value(self):
        result = self.conjunction()
        while self.next_is("||"):
            right = self.conjunction()
            result = result or right
        return result

    def conjunction(self):
        result = self.comparison()
        while self.next_is("&&"):
            right = self.comparison()
            result = result and right
        return result

    def comparison(self):
        result = self.operand()
        if self.next_is("=="):
            return result == self.operand()
        if self.next_is("!="):
            return result != self.operand()
        return result

    def operand(self):
        if self.next_is("!"):
            return not self.operand()
        if self.next_is("("):
            result = self.value()
            self.expect(")")
            return result
        if not self.tokens:
            raise ValueError("expression that ends too soon")
        token = self.tokens.pop(0)
        if token["text"]:
            return token["text"][1:-1].replace("''", "'")
        name = token["name"]
        if self.next_is("("):
            self.expect(")")
            return {"always": True, "success": not self.failed, "failure": self.failed}[name]
        found = self.contexts
        for part in name.split("."):
            found = found.get(part, "") if isinstance(found, dict) else ""
        return found

    def expect(self, sign):
        if not self.next_is(sign):
            raise ValueError(f"expression without its '{sign}'")


def evaluated(expression, contexts, failed=False):
    reader = Reader(expression, contexts, failed)
    result = reader.value()
    if reader.tokens:
        raise ValueError(f"expression with more behind its end: {expression}")
    return result


def is_to_run(condition, contexts, failed):
    """Whether a step with this `if` runs; without a status function it does not after a failure."""
    expression = re.sub(r"^\s*\$\{\{(.*)\}\}\s*$", r"\1", str(condition))
    if not re.search(r"\b(always|success|failure)\(\)", expression):
        expression = f"success() && ({expression})"
    return bool(evaluated(expression, contexts, failed))


def filled_in(text, contexts):
    """The text with the value of each ${{ expression }}."""
    return re.sub(r"\$\{\{(.*?)\}\}", lambda found: str(evaluated(found[1], contexts)), str(text))
