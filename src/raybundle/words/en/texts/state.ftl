# $n = 1
state-faults = Do not use yet: { $n } { $n ->
        [one] fault
        *[other] faults
    } to settle.

state-accuracy_not_kept = The required accuracy is not kept.

state-heights_relative = Heights are relative and tilted: the control has no measured heights.

# $text = "P1 lies 3 m away."
state-fault_text = { $text }
