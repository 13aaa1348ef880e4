# $name = "'a\\x1b'"
name-unprintable = { $name } is not a printable name.
    .do = Rename it.
