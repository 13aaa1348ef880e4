# $n = 12
# $waiting = 3
task_share-done = Tasks done: { $n }; waiting for other shares: { $waiting }.

# $name = "leaf 1"
task_share-failed = Task { $name } failed.

task_share-again = Run the same command again when the other shares are done.
