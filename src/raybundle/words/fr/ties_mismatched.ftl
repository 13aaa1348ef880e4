ties_mismatched = { $pairs } paire(s) de points de liaison rejetés ont été confondues : { $ids }.
