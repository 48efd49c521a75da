"""A course for tests: its key and its students."""


def write_course(place, files, secret, count):
    """Writes key.toml and roster.csv into the folder `place`; returns the names of the students."""
    listed = ", ".join(f'"{file}"' for file in files)
    (place / "key.toml").write_text(f'format = 1\nsecret = "{secret}"\nexercises = [{listed}]\n')
    students = [f"s{k}" for k in range(count)]
    (place / "roster.csv").write_text("student\n" + "\n".join(students) + "\n")
    return students
