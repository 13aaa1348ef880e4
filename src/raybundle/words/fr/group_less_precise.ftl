group_less_precise = Résidus ({ observations-kind }) { NUM($ratio, digits: 3) } fois plus grands qu'annoncé (toutes les observations : { $sigma0 }).

group_less_precise-weighted = Résidus ({ observations-kind }) { NUM($ratio, digits: 3) } fois plus grands qu'annoncé.
