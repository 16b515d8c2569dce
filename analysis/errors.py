"""The one error that a user of this package can cause."""


class InputError(Exception):
    """Broken input, with the file, the key inside it, what is wrong and what to do."""

    def __init__(self, file, key, problem, remedy):
        where = f"{file}: {key}" if key else str(file)
        super().__init__(f"{where}: {problem}; {remedy}")
