"""What a spelling checker need not look at."""

from enchant.tokenize import Filter


class Symbols(Filter):
    """Mathematics in running text: letters of other alphabets, and one or two letters side by side."""

    def _skip(self, word: str) -> bool:
        return sum(map(str.isalpha, word)) <= 2 or not word.isascii()
