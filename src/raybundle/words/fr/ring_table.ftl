ring_table-bits = Un anneau de { $bits } bits n'est pas possible.

ring_table-row = { $value } n'est pas un numéro et un code.

ring_table-code_out_of_range = Le code { $ring } n'est pas compris entre 1 et { $largest }.

ring_table-empty = La table ne contient aucune cible.

ring_table-ring_radii = Un anneau de { $inner } à { $outer } rayons du disque ne laisse pas d'intervalle.

ring_table-id_twice = Le numéro { $id } figure deux fois.

ring_table-ring_twice = L'anneau du code { $ring } appartient déjà au numéro { $id }.
