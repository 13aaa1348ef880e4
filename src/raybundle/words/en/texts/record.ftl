record-empty = The record has no entry.

# $oriented = false
record-next = { $oriented ->
        [yes] Run raybundle orient again: the report gets the record.
        *[no] Run raybundle orient: the report gets the record.
    }
