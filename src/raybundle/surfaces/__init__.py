"""The surface of what photographs show: depths, points, heights, products, each with its standard deviation."""
