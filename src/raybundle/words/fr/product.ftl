product-gone = Un produit de l'étape { $stage } est endommagé ou manque.

product-needs_heights = { $command } demande une surface avec des hauteurs.
