control_unchecked = { $n } point(s) d'appui non contrôlé(s) par les autres observations : { $ids }.

control_unchecked-axis = { $axis } de { $points } : une erreur inférieure à { NUM($least, digits: 2) } { $unit } en { $point } passerait inaperçue.

control_unchecked-no_limit = { $axis } de { $points } : aucune erreur ne serait remarquée.
