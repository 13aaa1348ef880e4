record-empty = The record has no entry.

# $oriented = false
record-next = { $oriented ->
        [yes] Run orient or mark adjust again: the report gets the record.
        *[no] Run raybundle orient: the report gets the record.
    }
