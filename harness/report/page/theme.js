// How all charts look. Colours are of Okabe and Ito, told apart by people who see few; every
// distinction is also one of shape, fill or word.

const kLightColours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#b58900", "#56b4e9", "#7f3c8d", "#5c5c5c"];
const kDarkColours = ["#4aa8e0", "#f0843c", "#2fc79a", "#e39ac4", "#e6b93d", "#8fd0f5", "#b98cc7", "#a8a8a8"];
export const kShapes = ["circle", "square", "triangle-up", "diamond", "cross", "triangle-down", "triangle-right", "triangle-left"];

export function theme(isDark) {
    const ink = isDark ? "#e6e6e6" : "#1f2328";
    const faint = isDark ? "#3a3f45" : "#dfe2e6";
    const soft = isDark ? "#a9b1ba" : "#57606a";
    const font = "system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif";
    return {
        font, background: null, padding: 4,
        view: { stroke: faint },
        axis: {
            gridColor: faint, domainColor: soft, tickColor: soft, labelColor: ink, titleColor: ink,
            titleFontWeight: 500, labelFontSize: 11, titleFontSize: 12, titlePadding: 6,
        },
        legend: { labelColor: ink, titleColor: ink, titleFontWeight: 500, labelLimit: 260, symbolSize: 80, titleLimit: 300 },
        title: { color: ink, subtitleColor: soft, fontSize: 13, fontWeight: 600, subtitleFontSize: 11, anchor: "start" },
        text: { color: ink, fontSize: 11 },
        rule: { color: soft },
        range: { category: colours(isDark), symbol: kShapes },
    };
}

export const colours = isDark => (isDark ? kDarkColours : kLightColours);
export const ink = isDark => (isDark ? "#e6e6e6" : "#1f2328");
export const paper = isDark => (isDark ? "#16191d" : "#ffffff");
