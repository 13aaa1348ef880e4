control_rejected = Le point d'appui { $point } contredit les autres observations (|w| { NUM($w, decimals: 1) }) et ne participe pas.
