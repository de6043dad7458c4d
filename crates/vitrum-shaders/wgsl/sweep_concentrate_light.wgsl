struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_11 {
member: u32,
member_1: u32,
}
struct type_12 {
member: type_11,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_13 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_14 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_11,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_11,
member_18: type_12,
member_19: type_5,
member_20: type_13,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: array<f32>,
}
struct type_19 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_20 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_21 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: i32,
member_10: i32,
member_11: type_2,
member_12: u32,
member_13: type_2,
member_14: u32,
member_15: u32,
}
struct type_22 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_23 {
member: type_5,
member_1: type_5,
}
struct type_24 {
member: type_7,
member_1: u32,
}
struct type_25 {
member: type_2,
member_1: u32,
member_2: type_19,
member_3: type_11,
member_4: type_11,
member_5: u32,
member_6: u32,
member_7: type_20,
member_8: type_21,
member_9: type_21,
member_10: type_22,
member_11: type_23,
member_12: type_14,
member_13: type_20,
member_14: type_4,
member_15: type_9,
member_16: type_24,
member_17: type_24,
member_18: type_24,
member_19: type_24,
member_20: type_10,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_26 {
member: type_25,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_26;
@group(0) @binding(2)
var<storage, read_write> global_2: type_16;
@group(0) @binding(1)
var<storage> global_3: type_16;
fn function_() {
var phi_927_: i32;
let _e34 = global;
let _e39 = global_1.member.member_2;
let _e42 = global_1.member.member;
let _e50 = (_e34.x + _e39.member);
let _e52 = (_e34.y + _e39.member_1);
if (_e50 < _e39.member_2) {
if (_e52 < _e39.member_3) {
let _e55 = (_e42.member * _e42.member_1);
let _e57 = ((_e52 * _e42.member) + _e50);
let _e58 = bitcast<i32>(_e50);
let _e59 = bitcast<i32>(_e52);
let _e63 = global_1.member.member_10.member;
let _e67 = global_1.member.member_10.member_1;
let _e69 = bitcast<i32>((_e63 * _e67));
let _e70 = (6i * _e69);
let _e71 = bitcast<i32>(_e63);
let _e73 = (_e70 + (_e59 * _e71));
let _e74 = (_e73 + _e58);
let _e76 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e78 = select(_e76, _e74, (_e74 < _e76));
let _e84 = global_3.member[bitcast<u32>(select(0i, _e78, (_e78 > 0i)))];
let _e86 = ((_e73 + _e69) + _e58);
let _e88 = select(_e76, _e86, (_e86 < _e76));
let _e94 = global_3.member[bitcast<u32>(select(0i, _e88, (_e88 > 0i)))];
let _e95 = (_e73 + -1i);
let _e96 = (_e95 + _e58);
let _e98 = select(_e76, _e96, (_e96 < _e76));
let _e104 = global_3.member[bitcast<u32>(select(0i, _e98, (_e98 > 0i)))];
let _e106 = ((_e95 + _e69) + _e58);
let _e108 = select(_e76, _e106, (_e106 < _e76));
let _e114 = global_3.member[bitcast<u32>(select(0i, _e108, (_e108 > 0i)))];
let _e115 = (_e73 + 1i);
let _e116 = (_e115 + _e58);
let _e118 = select(_e76, _e116, (_e116 < _e76));
let _e124 = global_3.member[bitcast<u32>(select(0i, _e118, (_e118 > 0i)))];
let _e126 = ((_e115 + _e69) + _e58);
let _e128 = select(_e76, _e126, (_e126 < _e76));
let _e134 = global_3.member[bitcast<u32>(select(0i, _e128, (_e128 > 0i)))];
let _e137 = (_e70 + ((_e59 - 1i) * _e71));
let _e138 = (_e137 + _e58);
let _e140 = select(_e76, _e138, (_e138 < _e76));
let _e146 = global_3.member[bitcast<u32>(select(0i, _e140, (_e140 > 0i)))];
let _e148 = ((_e137 + _e69) + _e58);
let _e150 = select(_e76, _e148, (_e148 < _e76));
let _e156 = global_3.member[bitcast<u32>(select(0i, _e150, (_e150 > 0i)))];
let _e159 = (_e70 + ((_e59 + 1i) * _e71));
let _e160 = (_e159 + _e58);
let _e162 = select(_e76, _e160, (_e160 < _e76));
let _e168 = global_3.member[bitcast<u32>(select(0i, _e162, (_e162 > 0i)))];
let _e170 = ((_e159 + _e69) + _e58);
let _e172 = select(_e76, _e170, (_e170 < _e76));
let _e178 = global_3.member[bitcast<u32>(select(0i, _e172, (_e172 > 0i)))];
let _e180 = select(0f, 1f, (_e58 > 0i));
let _e183 = select(0f, 1f, (_e58 < (_e71 - 1i)));
let _e186 = select(0f, 1f, (false || (_e59 > 0i)));
let _e191 = select(0f, 1f, (false || (_e59 < (bitcast<i32>(_e67) - 1i))));
let _e193 = ((_e84 - _e104) * _e180);
let _e195 = ((_e124 - _e84) * _e183);
let _e197 = (0.5f * (_e193 + _e195));
let _e201 = bitcast<f32>((bitcast<u32>(_e193) & 2147483647u));
let _e204 = bitcast<f32>((bitcast<u32>(_e195) & 2147483647u));
let _e207 = (2f * select(_e204, _e201, (_e201 < _e204)));
let _e210 = bitcast<f32>((bitcast<u32>(_e197) & 2147483647u));
let _e212 = select(_e207, _e210, (_e210 < _e207));
let _e222 = ((_e94 - _e114) * _e180);
let _e224 = ((_e134 - _e94) * _e183);
let _e226 = (0.5f * (_e222 + _e224));
let _e229 = bitcast<f32>((bitcast<u32>(_e222) & 2147483647u));
let _e232 = bitcast<f32>((bitcast<u32>(_e224) & 2147483647u));
let _e235 = (2f * select(_e232, _e229, (_e229 < _e232)));
let _e238 = bitcast<f32>((bitcast<u32>(_e226) & 2147483647u));
let _e240 = select(_e235, _e238, (_e238 < _e235));
let _e248 = ((_e84 - _e146) * _e186);
let _e250 = ((_e168 - _e84) * _e191);
let _e252 = (0.5f * (_e248 + _e250));
let _e255 = bitcast<f32>((bitcast<u32>(_e248) & 2147483647u));
let _e258 = bitcast<f32>((bitcast<u32>(_e250) & 2147483647u));
let _e261 = (2f * select(_e258, _e255, (_e255 < _e258)));
let _e264 = bitcast<f32>((bitcast<u32>(_e252) & 2147483647u));
let _e266 = select(_e261, _e264, (_e264 < _e261));
let _e274 = ((_e94 - _e156) * _e186);
let _e276 = ((_e178 - _e94) * _e191);
let _e278 = (0.5f * (_e274 + _e276));
let _e282 = bitcast<f32>((bitcast<u32>(_e274) & 2147483647u));
let _e285 = bitcast<f32>((bitcast<u32>(_e276) & 2147483647u));
let _e288 = (2f * select(_e285, _e282, (_e282 < _e285)));
let _e291 = bitcast<f32>((bitcast<u32>(_e278) & 2147483647u));
let _e293 = select(_e288, _e291, (_e291 < _e288));
let _e304 = bitcast<i32>((_e52 * _e63));
let _e306 = (((8i * _e69) + _e304) + _e58);
let _e308 = select(_e76, _e306, (_e306 < _e76));
let _e314 = global_3.member[bitcast<u32>(select(0i, _e308, (_e308 > 0i)))];
let _e324 = ((bitcast<f32>((bitcast<u32>((((1f + select(_e197, select(0f, select(_e212, -(_e212), (_e197 < 0f)), ((_e193 * _e195) > 0f)), (_e197 > 0f))) * (1f + select(_e278, select(0f, select(_e293, -(_e293), (_e278 < 0f)), ((_e274 * _e276) > 0f)), (_e278 > 0f)))) - (select(0f, select(_e240, -(_e240), (_e226 < 0f)), ((_e222 * _e224) > 0f)) * select(0f, select(_e266, -(_e266), (_e252 < 0f)), ((_e248 * _e250) > 0f))))) & 2147483647u)) * 1.25f) / select(1e-20f, _e314, (_e314 > 1e-20f)));
let _e329 = global_1.member.member_1;
let _e332 = select(select(_e324, 1f, (1f < _e324)), 1f, ((_e329 & 6u) != 0u));
let _e335 = (((3i * _e69) + _e304) + _e58);
let _e337 = select(_e76, _e335, (_e335 < _e76));
let _e343 = global_3.member[bitcast<u32>(select(0i, _e337, (_e337 > 0i)))];
let _e346 = (((4i * _e69) + _e304) + _e58);
let _e348 = select(_e76, _e346, (_e346 < _e76));
let _e354 = global_3.member[bitcast<u32>(select(0i, _e348, (_e348 > 0i)))];
let _e357 = (((5i * _e69) + _e304) + _e58);
let _e359 = select(_e76, _e357, (_e357 < _e76));
let _e365 = global_3.member[bitcast<u32>(select(0i, _e359, (_e359 > 0i)))];
let _e366 = (_e304 + _e58);
let _e368 = select(_e76, _e366, (_e366 < _e76));
let _e374 = global_3.member[bitcast<u32>(select(0i, _e368, (_e368 > 0i)))];
let _e376 = ((_e69 + _e304) + _e58);
let _e378 = select(_e76, _e376, (_e376 < _e76));
let _e384 = global_3.member[bitcast<u32>(select(0i, _e378, (_e378 > 0i)))];
let _e387 = (((2i * _e69) + _e304) + _e58);
let _e389 = select(_e76, _e387, (_e387 < _e76));
let _e395 = global_3.member[bitcast<u32>(select(0i, _e389, (_e389 > 0i)))];
let _e403 = (((_e343 * _e343) + (_e354 * _e354)) + (_e365 * _e365));
let _e406 = sqrt(select(0f, _e403, (_e403 > 0f)));
let _e409 = (1f / select(1e-20f, _e406, (_e406 > 1e-20f)));
let _e413 = global_1.member.member_11.member;
let _e417 = ((_e343 * _e409) - _e413.member);
let _e419 = ((_e354 * _e409) - _e413.member_1);
if (_e417 < 0f) {
let _e425 = ((bitcast<f32>((bitcast<u32>(_e417) & 2147483647u)) * 16255f) + 0.5f);
let _e426 = (2f * 16255f);
let _e428 = select(0f, _e425, (_e425 > 0f));
let _e430 = select(_e426, _e428, (_e428 < _e426));
let _e437 = select(0i, select(select(i32(_e430), i32(-2147483648), (_e430 < -2147483600f)), 2147483647i, (_e430 > 2147483500f)), (_e430 == _e430));
phi_927_ = (32768i - (_e437 - select(0i, 1i, (_e430 < f32(_e437)))));
} else {
let _e447 = ((bitcast<f32>((bitcast<u32>(_e417) & 2147483647u)) * 16255f) + 0.5f);
let _e448 = (2f * 16255f);
let _e450 = select(0f, _e447, (_e447 > 0f));
let _e452 = select(_e448, _e450, (_e450 < _e448));
let _e459 = select(0i, select(select(i32(_e452), i32(-2147483648), (_e452 < -2147483600f)), 2147483647i, (_e452 > 2147483500f)), (_e452 == _e452));
phi_927_ = (32768i + (_e459 - select(0i, 1i, (_e452 < f32(_e459)))));
}
let _e466 = phi_927_;
let _e471 = ((bitcast<f32>((bitcast<u32>(_e419) & 2147483647u)) * 16255f) + 0.5f);
let _e472 = (2f * 16255f);
let _e474 = select(0f, _e471, (_e471 > 0f));
let _e476 = select(_e472, _e474, (_e474 < _e472));
let _e483 = select(0i, select(select(i32(_e476), i32(-2147483648), (_e476 < -2147483600f)), 2147483647i, (_e476 > 2147483500f)), (_e476 == _e476));
let _e487 = (_e483 - select(0i, 1i, (_e476 < f32(_e483))));
global_2.member[_e57] = (_e374 * _e332);
global_2.member[(_e55 + _e57)] = (_e384 * _e332);
global_2.member[((2u * _e55) + _e57)] = (_e395 * _e332);
global_2.member[((3u * _e55) + _e57)] = bitcast<f32>(((select(0u, 2147483648u, ((_e419 < 0f) && (_e487 > 0i))) | (bitcast<u32>((_e487 + 128i)) << bitcast<u32>(16i))) | bitcast<u32>(_e466)));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
