# $first = "gsd"
# $second = "height"
option-exclusive = { OPTION($first) } and { OPTION($second) } exclude each other.
    .do = Give one of them.

# $setting = "interval"
# $value = "HEIGHT"
option-missing = { OPTION($setting, $value) } is missing.
    .do = Add it.

# $setting = "by"
# $other = "axes"
option-needs = { OPTION($setting) } needs { OPTION($other) }.
    .do = Give both, or leave both out.

# $first = "codes"
# $second = "count"
option-one_of = Exactly one of { OPTION($first) } and { OPTION($second) } is needed.
    .do = Give one of them.
