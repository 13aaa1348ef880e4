# $name = "colour"
# $known = ["control", "crs"]
setting-unknown = Setting { $name } is unknown.
    .do = Give one of { LIST($known, most: 60) }.

# $name = "masks"
# $given = "yes"
# $flag = true
setting-wrong_kind = { $name } = { $given } is not possible: { $flag ->
        [yes] true or false is needed
       *[no] a value is needed
    }.
    .do = { $flag ->
            [yes] Give true or false for { $name }
            *[no] Give a value for { $name }
        }.

# $name = "target"
# $given = "['rings12', 'rings14']"
setting-several_values = { $name } = { $given } is not a single value.
    .do = Write several names in one text, with commas between them.

# $name = "photos"
# $given = "'site photos"
setting-quotation_open = { $name } = { $given }: a quotation mark is not closed.
    .do = Close the quotation mark.

# $name = "out"
# $given = "'re\\x00sult'"
setting-impossible_character = { $name } = { $given } contains a character that is impossible in file names.
    .do = Type the name again.

# $name = "scale_bar"
# $given = "A B"
# $needed = 3
# $form = "A B LENGTH"
setting-word_count = { $name } = { $given } has not the form { $form }.
    .do = Give { $needed } { $needed ->
        [one] value
       *[other] values
    } each time: { $form }.

# $name = "photos"
# $given = "12"
setting-no_text = { $name } = { $given } is not a text.
    .do = Give folders and files in one text, with blanks between them.

# $name = "x"
# $given = "left"
setting-no_number = { $name } = { $given } is not a number.
    .do = Give a number.

# $name = "lever_arm"
# $gps = true
setting-needs_positions = { OPTION($name) } needs positions: { $gps ->
        [yes] no photograph has one
       *[no] { OPTION("gps", "False", flag: "no-gps") } excludes those of the photographs
    }.
    .do = Give { OPTION("positions") } or photographs with positions, or omit { OPTION($name) }.

# $name = "memory"
# $given = "nan"
setting-not_finite = { $name } = { $given } is not a finite number.
    .do = Give a finite number.

# $name = "memory"
# $given = "-1"
# $least = 0
# $above = true
setting-too_small = { $name } = { $given } is too small; it must be { $above ->
        [yes] greater than
        *[no] at least
    } { $least }.
    .do = { $above ->
            [yes] Give a value above { $least }
            *[no] Give { $least } or more
        }.

# $name = "lines"
# $given = "99"
# $most = 40
setting-too_large = { $name } = { $given } is too large; the limit is { $most }.
    .do = Give { $most } or less.

# $name = "noise"
# $given = "'pink'"
# $known = ["white", "fields", "auto"]
setting-not_one_of = { $name } = { $given } is not a possible value.
    .do = Give one of { LIST($known, most: 60) }.

# $name = "control_sigma"
# $given = "(0.1,)"
# $n = 2
setting-value_count = { $name } = { $given }: { $n } values are needed.
    .do = Give { $name } with { $n } values.

# $name = "target"
# $given = "7"
# $type = "str"
setting-wrong_type = { $name } = { $given } is not of type { $type }.
    .do = Give { $name } as { $type }.

# $name = "feature_count"
# $given = "99.5"
setting-no_whole_number = { $name } = { $given } is not a whole number.
    .do = Give a whole number.

# $name = "source"
# $type = "Block"
setting-no_path = { $name } is an object of type { $type }, not a path.
    .do = Write it with write_result or write_block, and give the folder.
