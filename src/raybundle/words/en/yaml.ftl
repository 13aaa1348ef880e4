yaml-indentation = The line is indented less than the block it belongs to.
    .do = Correct the indentation.

yaml-second_document = A second document begins here.
    .do = Give each document in its own file.

yaml-tab = The line is indented with a tab.
    .do = Use blanks.

yaml-open_list = A list that begins here has no end.
    .do = Check that the file is complete.

yaml-no_entry = An entry KEY: VALUE is expected here.
    .do = Correct this line.

yaml-list_form = The list has a wrong form.
    .do = Separate its elements by commas, and close it.

yaml-not_supported = Anchors and block texts of YAML are not supported.
    .do = Write plain values.
