selection-nothing_beyond = Aucune observation image ne dépasse { $limit } en { $quantity }.

selection-unknown_quantity = La grandeur { $quantity } est inconnue.
