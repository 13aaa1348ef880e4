# $folder = "facade-project"
interruption-kept = Interrupted. The same command continues in { $folder }.

interruption-nothing_written = Interrupted; nothing was written.
