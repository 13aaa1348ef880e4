reason-text = Remarque : { $text }

reason-more = { $n } de plus.
