interface Window {
  usdrigui: any;
}
declare module '*.css';
