struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_6 {
member: array<f32>,
}
struct type_10 {
member: type_4,
member_1: type_4,
member_2: type_4,
member_3: type_4,
member_4: type_4,
member_5: vec4<i32>,
member_6: vec4<i32>,
member_7: vec4<i32>,
}
struct type_11 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
member_4: type_4,
member_5: type_10,
member_6: type_10,
member_7: type_4,
member_8: type_4,
member_9: type_4,
member_10: type_4,
member_11: type_4,
member_12: type_4,
member_13: type_4,
member_14: type_4,
member_15: type_4,
member_16: type_4,
member_17: type_4,
member_18: type_4,
member_19: type_4,
member_20: type_4,
member_21: type_4,
member_22: type_4,
member_23: type_4,
member_24: type_4,
member_25: vec4<u32>,
member_26: type_4,
member_27: type_4,
member_28: type_4,
member_29: type_4,
member_30: type_4,
member_31: type_4,
}
struct type_12 {
member: type_11,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_12;
@group(0) @binding(1)
var<storage> global_2: type_6;
@group(0) @binding(2)
var<storage, read_write> global_3: type_6;
fn function_() {
var phi_878_: i32;
let _e35 = global;
let _e40 = global_1.member.member_1;
let _e43 = (_e35.x + _e40.x);
let _e46 = (_e35.y + _e40.y);
if (_e43 < _e40.z) {
if (_e46 < _e40.w) {
let _e54 = global_1.member.member[0u];
let _e58 = global_1.member.member[1u];
let _e59 = (_e54 * _e58);
let _e61 = ((_e46 * _e54) + _e43);
let _e62 = bitcast<i32>(_e43);
let _e63 = bitcast<i32>(_e46);
let _e67 = global_1.member.member_2[2u];
let _e71 = global_1.member.member_2[3u];
let _e73 = bitcast<i32>((_e67 * _e71));
let _e74 = (6i * _e73);
let _e75 = bitcast<i32>(_e67);
let _e77 = (_e74 + (_e63 * _e75));
let _e78 = (_e77 + _e62);
let _e80 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e82 = select(_e80, _e78, (_e78 < _e80));
let _e88 = global_2.member[bitcast<u32>(select(0i, _e82, (_e82 > 0i)))];
let _e90 = ((_e77 + _e73) + _e62);
let _e92 = select(_e80, _e90, (_e90 < _e80));
let _e98 = global_2.member[bitcast<u32>(select(0i, _e92, (_e92 > 0i)))];
let _e99 = (_e77 + -1i);
let _e100 = (_e99 + _e62);
let _e102 = select(_e80, _e100, (_e100 < _e80));
let _e108 = global_2.member[bitcast<u32>(select(0i, _e102, (_e102 > 0i)))];
let _e110 = ((_e99 + _e73) + _e62);
let _e112 = select(_e80, _e110, (_e110 < _e80));
let _e118 = global_2.member[bitcast<u32>(select(0i, _e112, (_e112 > 0i)))];
let _e119 = (_e77 + 1i);
let _e120 = (_e119 + _e62);
let _e122 = select(_e80, _e120, (_e120 < _e80));
let _e128 = global_2.member[bitcast<u32>(select(0i, _e122, (_e122 > 0i)))];
let _e130 = ((_e119 + _e73) + _e62);
let _e132 = select(_e80, _e130, (_e130 < _e80));
let _e138 = global_2.member[bitcast<u32>(select(0i, _e132, (_e132 > 0i)))];
let _e141 = (_e74 + ((_e63 - 1i) * _e75));
let _e142 = (_e141 + _e62);
let _e144 = select(_e80, _e142, (_e142 < _e80));
let _e150 = global_2.member[bitcast<u32>(select(0i, _e144, (_e144 > 0i)))];
let _e152 = ((_e141 + _e73) + _e62);
let _e154 = select(_e80, _e152, (_e152 < _e80));
let _e160 = global_2.member[bitcast<u32>(select(0i, _e154, (_e154 > 0i)))];
let _e163 = (_e74 + ((_e63 + 1i) * _e75));
let _e164 = (_e163 + _e62);
let _e166 = select(_e80, _e164, (_e164 < _e80));
let _e172 = global_2.member[bitcast<u32>(select(0i, _e166, (_e166 > 0i)))];
let _e174 = ((_e163 + _e73) + _e62);
let _e176 = select(_e80, _e174, (_e174 < _e80));
let _e182 = global_2.member[bitcast<u32>(select(0i, _e176, (_e176 > 0i)))];
let _e184 = select(0f, 1f, (_e62 > 0i));
let _e187 = select(0f, 1f, (_e62 < (_e75 - 1i)));
let _e190 = select(0f, 1f, (false || (_e63 > 0i)));
let _e195 = select(0f, 1f, (false || (_e63 < (bitcast<i32>(_e71) - 1i))));
let _e197 = ((_e88 - _e108) * _e184);
let _e199 = ((_e128 - _e88) * _e187);
let _e201 = (0.5f * (_e197 + _e199));
let _e205 = bitcast<f32>((bitcast<u32>(_e197) & 2147483647u));
let _e208 = bitcast<f32>((bitcast<u32>(_e199) & 2147483647u));
let _e211 = (2f * select(_e208, _e205, (_e205 < _e208)));
let _e214 = bitcast<f32>((bitcast<u32>(_e201) & 2147483647u));
let _e216 = select(_e211, _e214, (_e214 < _e211));
let _e226 = ((_e98 - _e118) * _e184);
let _e228 = ((_e138 - _e98) * _e187);
let _e230 = (0.5f * (_e226 + _e228));
let _e233 = bitcast<f32>((bitcast<u32>(_e226) & 2147483647u));
let _e236 = bitcast<f32>((bitcast<u32>(_e228) & 2147483647u));
let _e239 = (2f * select(_e236, _e233, (_e233 < _e236)));
let _e242 = bitcast<f32>((bitcast<u32>(_e230) & 2147483647u));
let _e244 = select(_e239, _e242, (_e242 < _e239));
let _e252 = ((_e88 - _e150) * _e190);
let _e254 = ((_e172 - _e88) * _e195);
let _e256 = (0.5f * (_e252 + _e254));
let _e259 = bitcast<f32>((bitcast<u32>(_e252) & 2147483647u));
let _e262 = bitcast<f32>((bitcast<u32>(_e254) & 2147483647u));
let _e265 = (2f * select(_e262, _e259, (_e259 < _e262)));
let _e268 = bitcast<f32>((bitcast<u32>(_e256) & 2147483647u));
let _e270 = select(_e265, _e268, (_e268 < _e265));
let _e278 = ((_e98 - _e160) * _e190);
let _e280 = ((_e182 - _e98) * _e195);
let _e282 = (0.5f * (_e278 + _e280));
let _e286 = bitcast<f32>((bitcast<u32>(_e278) & 2147483647u));
let _e289 = bitcast<f32>((bitcast<u32>(_e280) & 2147483647u));
let _e292 = (2f * select(_e289, _e286, (_e286 < _e289)));
let _e295 = bitcast<f32>((bitcast<u32>(_e282) & 2147483647u));
let _e297 = select(_e292, _e295, (_e295 < _e292));
let _e308 = bitcast<i32>((_e46 * _e67));
let _e310 = (((8i * _e73) + _e308) + _e62);
let _e312 = select(_e80, _e310, (_e310 < _e80));
let _e318 = global_2.member[bitcast<u32>(select(0i, _e312, (_e312 > 0i)))];
let _e328 = ((bitcast<f32>((bitcast<u32>((((1f + select(_e201, select(0f, select(_e216, -(_e216), (_e201 < 0f)), ((_e197 * _e199) > 0f)), (_e201 > 0f))) * (1f + select(_e282, select(0f, select(_e297, -(_e297), (_e282 < 0f)), ((_e278 * _e280) > 0f)), (_e282 > 0f)))) - (select(0f, select(_e244, -(_e244), (_e230 < 0f)), ((_e226 * _e228) > 0f)) * select(0f, select(_e270, -(_e270), (_e256 < 0f)), ((_e252 * _e254) > 0f))))) & 2147483647u)) * 1.25f) / select(1e-20f, _e318, (_e318 > 1e-20f)));
let _e334 = global_1.member.member[3u];
let _e337 = select(select(_e328, 1f, (1f < _e328)), 1f, ((_e334 & 6u) != 0u));
let _e340 = (((3i * _e73) + _e308) + _e62);
let _e342 = select(_e80, _e340, (_e340 < _e80));
let _e348 = global_2.member[bitcast<u32>(select(0i, _e342, (_e342 > 0i)))];
let _e351 = (((4i * _e73) + _e308) + _e62);
let _e353 = select(_e80, _e351, (_e351 < _e80));
let _e359 = global_2.member[bitcast<u32>(select(0i, _e353, (_e353 > 0i)))];
let _e362 = (((5i * _e73) + _e308) + _e62);
let _e364 = select(_e80, _e362, (_e362 < _e80));
let _e370 = global_2.member[bitcast<u32>(select(0i, _e364, (_e364 > 0i)))];
let _e371 = (_e308 + _e62);
let _e373 = select(_e80, _e371, (_e371 < _e80));
let _e379 = global_2.member[bitcast<u32>(select(0i, _e373, (_e373 > 0i)))];
let _e382 = ((_e73 + _e308) + _e62);
let _e384 = select(_e80, _e382, (_e382 < _e80));
let _e390 = global_2.member[bitcast<u32>(select(0i, _e384, (_e384 > 0i)))];
let _e394 = (((2i * _e73) + _e308) + _e62);
let _e396 = select(_e80, _e394, (_e394 < _e80));
let _e402 = global_2.member[bitcast<u32>(select(0i, _e396, (_e396 > 0i)))];
let _e408 = (((_e348 * _e348) + (_e359 * _e359)) + (_e370 * _e370));
let _e411 = sqrt(select(0f, _e408, (_e408 > 0f)));
let _e414 = (1f / select(1e-20f, _e411, (_e411 > 1e-20f)));
let _e417 = global_1.member.member_10;
let _e421 = ((_e348 * _e414) - _e417.member);
let _e423 = ((_e359 * _e414) - _e417.member_1);
if (_e421 < 0f) {
let _e429 = ((bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) * 16255f) + 0.5f);
let _e430 = (2f * 16255f);
let _e432 = select(0f, _e429, (_e429 > 0f));
let _e434 = select(_e430, _e432, (_e432 < _e430));
let _e441 = select(0i, select(select(i32(_e434), i32(-2147483648), (_e434 < -2147483600f)), 2147483647i, (_e434 > 2147483500f)), (_e434 == _e434));
phi_878_ = (32768i - (_e441 - select(0i, 1i, (_e434 < f32(_e441)))));
} else {
let _e451 = ((bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) * 16255f) + 0.5f);
let _e452 = (2f * 16255f);
let _e454 = select(0f, _e451, (_e451 > 0f));
let _e456 = select(_e452, _e454, (_e454 < _e452));
let _e463 = select(0i, select(select(i32(_e456), i32(-2147483648), (_e456 < -2147483600f)), 2147483647i, (_e456 > 2147483500f)), (_e456 == _e456));
phi_878_ = (32768i + (_e463 - select(0i, 1i, (_e456 < f32(_e463)))));
}
let _e470 = phi_878_;
let _e477 = ((bitcast<f32>((bitcast<u32>(_e423) & 2147483647u)) * 16255f) + 0.5f);
let _e478 = (2f * 16255f);
let _e480 = select(0f, _e477, (_e477 > 0f));
let _e482 = select(_e478, _e480, (_e480 < _e478));
let _e489 = select(0i, select(select(i32(_e482), i32(-2147483648), (_e482 < -2147483600f)), 2147483647i, (_e482 > 2147483500f)), (_e482 == _e482));
global_3.member[_e61] = (_e379 * _e337);
global_3.member[(_e59 + _e61)] = (_e390 * _e337);
global_3.member[((2u * _e59) + _e61)] = (_e402 * _e337);
global_3.member[((3u * _e59) + _e61)] = bitcast<f32>(((select(0u, 2147483648u, (_e423 < 0f)) | (bitcast<u32>(((_e489 - select(0i, 1i, (_e482 < f32(_e489)))) + 128i)) << bitcast<u32>(16i))) | bitcast<u32>(_e470)));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
