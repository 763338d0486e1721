const INTERVALS_S = [
  0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400, 28800,
];

/** The distance of the marks on an axis of `total_s` seconds so that there are at most `most`, s. */
export function clockInterval(total_s, most) {
  const fitting = INTERVALS_S.find((interval) => total_s / interval <= most);
  return fitting ?? Math.ceil(total_s / most / 86400) * 86400;
}
