journal-nothing_to_undo = There is nothing to undo.
    .do = Correct or delete the measurement itself.

journal-nothing_to_redo = There is nothing to redo: the last action was not undone.
    .do = Repeat the action by hand.

journal-no_place = Nothing can be measured in this folder.
    .do = Give a project, result or block folder.

# $other = "facade/measured.db"
journal-two_journals = The project has two journals: this one, beside its result, and { $other }.
    .do = Move one of them elsewhere; a journal is valid under both names.

# $entry = "author"
# $text = "'xxx'"
# $n = 300
# $most = 200
journal-text_too_long = { $entry } { $text } has { $n } characters; at most { $most } are possible.
    .do = Choose a shorter text.

# $entry = "author"
# $text = "'a\\x00'"
journal-text_not_printable = { $entry } { $text } contains unprintable characters.
    .do = Choose another text.

# $id = "'a1'"
# $action = 12
# $verb = "put"
journal-id_used = Action id { $id } is already used by another action, { $action } ({ $verb }).
    .do = Give each action its own id.

journal-moved = The journal was moved, deleted or exchanged since it was opened; nothing was added.
    .do = Restore the folder, or open it at its present place.

# $action = "12"
journal-damaged = Action { $action } of the journal is damaged.
    .do = Restore the file from a copy.

# $verb = "put"
journal-number_not_finite = { $verb }: a number is not finite.
    .do = Give finite numbers.

journal-other_database = This database is not a journal of measurements.
    .do = Move it elsewhere.

# $found = "2"
# $read = "1"
journal-schema = The journal was written by another version (schema { $found }; this version reads { $read }).
    .do = Use that version.

# $action = 12
journal-foreign_action = Action { $action } of the journal is invalid.
    .do = Restore the file from a copy.

# $folder = "facade"
journal-read_only = Nothing can be measured: the folder { $folder } cannot be written.
    .why = Its content can be viewed.
    .do = Allow writing in it, or copy it elsewhere, and open it again.

# $cause = "locked"
# $detail = "database is locked"
journal-not_usable = The journal cannot be used ({ $detail }).
    .do = { $cause ->
        [locked] End the other program that holds the file, and try again
        [full] Free disk space, and try again
        [damaged] Restore the file from a copy, or move it elsewhere
        [read_only] Allow writing in the folder, and repeat the last step
       *[other] Check that the folder exists and can be written
     }.
