deviation-parameter_not_free = Image { $image } dans deviations.csv : { $parameter } n'est pas estimé par image.
