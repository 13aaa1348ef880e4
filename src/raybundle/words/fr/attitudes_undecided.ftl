attitudes_undecided = Les attitudes de { $source } ne sont pas utilisées : { $ids } sont possibles.
