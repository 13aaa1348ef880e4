# $detail = "mismatched tag"
# $cut = false
xml-invalid = This is not valid XML: { $detail }.
    .do = { $cut ->
        [yes] Get the file again: its end is missing
       *[no] Correct this line
     }.

# $path = "sensor/calibration"
xml-element_missing = Element { $path } is missing.
    .do = Check that the file is complete.

# $name = "id"
xml-attribute_missing = Attribute { $name } is missing.
    .do = Check that the file is complete.

# $name = "width"
# $value = "'abc'"
# $largest = 1e+18
xml-attribute_not_a_number = Attribute { $name }: { $value } is not a finite number.
    .do = Give a number of at most { $largest }.

xml-doctype = The document type (DOCTYPE) is refused for security reasons.
    .do = Delete it from the file.

# $root = "document"
xml-empty = The file has no root element; { $root } is expected.
    .do = Check that it is the right file.

# $name = "'html'"
# $root = "document"
xml-root_element = The root element is { $name }, not { $root }.
    .do = Check that it is the right file.
