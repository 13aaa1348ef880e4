"""What is made of measured points: which moved between epochs, how they fit nominal coordinates, whether lengths hold.

Everything is reckoned from sets of points with their joint covariance (`PointSet`); nothing here knows photographs.
"""
