// The same as index.cjs, for `import`.
import foresee from "./index.cjs";

export const { getLoadablePath, load } = foresee;
export default foresee;
