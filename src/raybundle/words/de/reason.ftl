reason-text = Hinweis: { $text }

reason-more = { $n } weitere.
