blunder_not_located = { $n } point(s) écarté(s) : trop peu de rayons pour identifier le rayon faux.
