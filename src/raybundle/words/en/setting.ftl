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
