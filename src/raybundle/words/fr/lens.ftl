lens-not_positive = { $entry } = { $value } n'est pas possible.

lens-focus_too_near = Un objectif de c = { $c_mm } mm ne peut pas être mis au point à { $focus_m } m.
