# $text = "timeout"
reason-text = Note: { $text }

# $n = 5
reason-more = { $n } more.
