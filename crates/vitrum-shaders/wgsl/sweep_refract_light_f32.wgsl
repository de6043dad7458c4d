struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_6 {
member: array<f32>,
}
struct type_11 {
member: array<u32>,
}
struct type_13 {
member: type_4,
member_1: type_4,
member_2: type_4,
member_3: type_4,
member_4: type_4,
member_5: vec4<i32>,
member_6: vec4<i32>,
member_7: vec4<i32>,
}
struct type_14 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
member_4: type_4,
member_5: type_13,
member_6: type_13,
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
struct type_15 {
member: type_14,
}
struct type_18 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_19 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_20 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_21 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_22 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_15;
@group(0) @binding(1)
var<storage> global_2: type_11;
@group(0) @binding(3)
var<storage> global_3: type_11;
@group(0) @binding(4)
var<storage> global_4: type_11;
@group(0) @binding(6)
var<storage, read_write> global_5: type_6;
@group(0) @binding(5)
var<storage> global_6: type_6;
fn function_() {
var local: type_18;
var local_1: vec3<f32>;
var local_2: type_18;
var local_3: vec3<f32>;
var local_4: type_18;
var local_5: vec3<f32>;
var phi_944_: u32;
var phi_5327_: type_19;
var phi_6647_: type_20;
var phi_8132_: type_21;
var phi_9242_: type_22;
var phi_9393_: f32;
var phi_9394_: f32;
var phi_9395_: f32;
var phi_9396_: f32;
let _e83 = global;
let _e86 = arrayLength((&global_2.member));
let _e90 = arrayLength((&global_4.member));
let _e92 = arrayLength((&global_6.member));
let _e97 = global_1.member.member_1;
let _e100 = (_e83.x + _e97.x);
let _e103 = (_e83.y + _e97.y);
if (_e100 < _e97.z) {
if (_e103 < _e97.w) {
let _e111 = global_1.member.member[0u];
let _e115 = global_1.member.member[1u];
let _e116 = (_e111 * _e115);
let _e118 = ((_e103 * _e111) + _e100);
let _e119 = bitcast<i32>(_e118);
let _e121 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e123 = select(_e121, _e119, (_e119 < _e121));
let _e129 = global_5.member[bitcast<u32>(select(0i, _e123, (_e123 > 0i)))];
let _e130 = (_e116 + _e118);
let _e131 = bitcast<i32>(_e130);
let _e133 = select(_e121, _e131, (_e131 < _e121));
let _e139 = global_5.member[bitcast<u32>(select(0i, _e133, (_e133 > 0i)))];
let _e141 = ((2u * _e116) + _e118);
let _e142 = bitcast<i32>(_e141);
let _e144 = select(_e121, _e142, (_e142 < _e121));
let _e150 = global_5.member[bitcast<u32>(select(0i, _e144, (_e144 > 0i)))];
let _e152 = ((3u * _e116) + _e118);
let _e153 = bitcast<i32>(_e152);
let _e155 = select(_e121, _e153, (_e153 < _e121));
let _e161 = global_5.member[bitcast<u32>(select(0i, _e155, (_e155 > 0i)))];
let _e163 = ((4u * _e116) + _e118);
let _e164 = bitcast<i32>(_e163);
let _e166 = select(_e121, _e164, (_e164 < _e121));
let _e172 = global_5.member[bitcast<u32>(select(0i, _e166, (_e166 > 0i)))];
let _e174 = ((5u * _e116) + _e118);
let _e175 = bitcast<i32>(_e174);
let _e177 = select(_e121, _e175, (_e175 < _e121));
let _e183 = global_5.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e185 = ((6u * _e116) + _e118);
let _e186 = bitcast<i32>(_e185);
let _e188 = select(_e121, _e186, (_e186 < _e121));
let _e194 = global_5.member[bitcast<u32>(select(0i, _e188, (_e188 > 0i)))];
let _e196 = ((7u * _e116) + _e118);
let _e197 = bitcast<i32>(_e196);
let _e199 = select(_e121, _e197, (_e197 < _e121));
let _e205 = global_5.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e207 = ((8u * _e116) + _e118);
let _e208 = bitcast<i32>(_e207);
let _e210 = select(_e121, _e208, (_e208 < _e121));
let _e216 = global_5.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
let _e220 = global_1.member.member_2[2u];
let _e224 = global_1.member.member_2[3u];
let _e225 = (_e220 * _e224);
if (_e92 >= (_e225 * 2u)) {
let _e229 = bitcast<i32>((_e103 * _e220));
let _e231 = bitcast<i32>(_e100);
let _e236 = global_6.member[bitcast<u32>((_e229 + _e231))];
let _e242 = global_6.member[bitcast<u32>(((bitcast<i32>(_e225) + _e229) + _e231))];
let _e243 = f32(_e231);
let _e245 = f32(bitcast<i32>(_e103));
let _e251 = global_1.member.member_4.member;
let _e255 = global_1.member.member_8.member_2;
let _e256 = (_e251 - _e255);
let _e260 = global_1.member.member_7.member;
let _e264 = global_1.member.member_8.member;
let _e271 = global_1.member.member_7.member_2;
let _e273 = ((_e260 + (_e264 * _e256)) + (((_e243 - _e236) + 0.5f) * _e271));
let _e277 = global_1.member.member_7.member_1;
let _e281 = global_1.member.member_8.member_1;
let _e286 = ((_e277 + (_e281 * _e256)) + (((_e245 - _e242) + 0.5f) * _e271));
let _e290 = global_1.member.member_4.member_1;
let _e291 = (_e290 - _e255);
let _e296 = ((_e260 + (_e264 * _e291)) + ((_e243 + 0.5f) * _e271));
let _e301 = ((_e277 + (_e281 * _e291)) + ((_e245 + 0.5f) * _e271));
let _e305 = global_1.member.member_5.member;
let _e318 = global_1.member.member_5.member.member_3;
let _e319 = ((((_e305.member * _e273) + (_e305.member_1 * _e286)) + (_e305.member_2 * _e251)) + _e318);
let _e323 = global_1.member.member_5.member_1;
let _e336 = global_1.member.member_5.member_1.member_3;
let _e337 = ((((_e323.member * _e273) + (_e323.member_1 * _e286)) + (_e323.member_2 * _e251)) + _e336);
let _e341 = global_1.member.member_5.member_2;
let _e354 = global_1.member.member_5.member_2.member_3;
let _e355 = ((((_e341.member * _e273) + (_e341.member_1 * _e286)) + (_e341.member_2 * _e251)) + _e354);
let _e361 = ((((_e305.member * _e296) + (_e305.member_1 * _e301)) + (_e305.member_2 * _e290)) + _e318);
let _e367 = ((((_e323.member * _e296) + (_e323.member_1 * _e301)) + (_e323.member_2 * _e290)) + _e336);
let _e373 = ((((_e341.member * _e296) + (_e341.member_1 * _e301)) + (_e341.member_2 * _e290)) + _e354);
let _e379 = global_1.member.member_5.member_3.member;
let _e380 = (_e379 - 1f);
let _e389 = global_1.member.member_5.member_3.member_1;
let _e390 = (_e389 - 1f);
let _e399 = global_1.member.member_5.member_3.member_2;
let _e400 = (_e399 - 1f);
let _e420 = global_1.member.member_5.member_3.member_3;
let _e421 = (_e379 - 0.5f);
let _e423 = select(-0.5f, _e361, (_e361 > -0.5f));
let _e425 = select(_e421, _e423, (_e423 < _e421));
let _e426 = (_e389 - 0.5f);
let _e428 = select(-0.5f, _e367, (_e367 > -0.5f));
let _e430 = select(_e426, _e428, (_e428 < _e426));
let _e431 = (_e399 - 0.5f);
let _e433 = select(-0.5f, _e373, (_e373 > -0.5f));
let _e435 = select(_e431, _e433, (_e433 < _e431));
let _e441 = bitcast<f32>((bitcast<u32>((_e361 - _e319)) & 2147483647u));
let _e444 = bitcast<f32>((bitcast<u32>((_e367 - _e337)) & 2147483647u));
let _e446 = select(_e444, _e441, (_e441 > _e444));
let _e449 = bitcast<f32>((bitcast<u32>((_e373 - _e355)) & 2147483647u));
let _e458 = bitcast<f32>((bitcast<u32>((_e361 - _e425)) & 2147483647u));
let _e461 = bitcast<f32>((bitcast<u32>((_e367 - _e430)) & 2147483647u));
let _e463 = select(_e461, _e458, (_e458 > _e461));
let _e466 = bitcast<f32>((bitcast<u32>((_e373 - _e435)) & 2147483647u));
let _e470 = (_e425 + 0.5f);
let _e472 = select(0f, _e470, (_e470 > 0f));
let _e474 = select(_e380, _e472, (_e472 < _e380));
let _e481 = select(0i, select(select(i32(_e474), i32(-2147483648), (_e474 < -2147483600f)), 2147483647i, (_e474 > 2147483500f)), (_e474 == _e474));
let _e490 = global_1.member.member_5.member_7[3u];
let _e491 = (_e490 & 31i);
let _e494 = (_e430 + 0.5f);
let _e496 = select(0f, _e494, (_e494 > 0f));
let _e498 = select(_e390, _e496, (_e496 < _e390));
let _e505 = select(0i, select(select(i32(_e498), i32(-2147483648), (_e498 < -2147483600f)), 2147483647i, (_e498 > 2147483500f)), (_e498 == _e498));
let _e512 = (_e435 + 0.5f);
let _e514 = select(0f, _e512, (_e512 > 0f));
let _e516 = select(_e400, _e514, (_e514 < _e400));
let _e523 = select(0i, select(select(i32(_e516), i32(-2147483648), (_e516 < -2147483600f)), 2147483647i, (_e516 > 2147483500f)), (_e516 == _e516));
let _e534 = global_1.member.member_5.member_6[3u];
let _e540 = global_1.member.member_5.member_6[0u];
let _e545 = global_1.member.member_5.member_6[1u];
let _e549 = ((_e534 + ((_e481 - select(0i, 1i, (_e474 < f32(_e481)))) >> bitcast<u32>(_e491))) + (_e540 * (((_e505 - select(0i, 1i, (_e498 < f32(_e505)))) >> bitcast<u32>(_e491)) + (_e545 * ((_e523 - select(0i, 1i, (_e516 < f32(_e523)))) >> bitcast<u32>(_e491))))));
let _e551 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e553 = select(_e551, _e549, (_e549 < _e551));
let _e559 = global_3.member[bitcast<u32>(select(0i, _e553, (_e553 > 0i)))];
let _e566 = global_1.member.member[3u];
phi_944_ = select(select(7u, 3u, (((((((_e319 >= 0f) && (_e319 <= _e380)) && (_e337 >= 0f)) && (_e337 <= _e390)) && (_e355 >= 0f)) && (_e355 <= _e400)) && ((((((_e361 >= 0f) && (_e361 <= _e380)) && (_e367 >= 0f)) && (_e367 <= _e390)) && (_e373 >= 0f)) && (_e373 <= _e400)))), 1u, (((_e566 & 64u) != 0u) || ((((select(_e449, _e446, (_e446 > _e449)) <= _e420) && ((select(_e466, _e463, (_e463 > _e466)) > _e420) || (_e559 != 0u))) && true) && ((_e566 & 32u) != 0u))));
} else {
phi_944_ = 7u;
}
let _e576 = phi_944_;
if (_e576 > 1u) {
let _e581 = global_1.member.member[2u];
let _e584 = bitcast<i32>(((_e103 * _e220) + _e100));
let _e587 = (bitcast<i32>(_e92) - 1i);
let _e589 = select(_e587, _e584, (_e584 < _e587));
let _e595 = global_6.member[bitcast<u32>(select(0i, _e589, (_e589 > 0i)))];
let _e596 = (bitcast<i32>(_e225) + _e584);
let _e598 = select(_e587, _e596, (_e596 < _e587));
let _e604 = global_6.member[bitcast<u32>(select(0i, _e598, (_e598 > 0i)))];
let _e606 = f32(bitcast<i32>(_e100));
let _e608 = f32(bitcast<i32>(_e103));
let _e614 = global_1.member.member_4.member;
let _e618 = global_1.member.member_8.member_2;
let _e619 = (_e614 - _e618);
let _e623 = global_1.member.member_7.member;
let _e627 = global_1.member.member_8.member;
let _e634 = global_1.member.member_7.member_2;
let _e636 = ((_e623 + (_e627 * _e619)) + (((_e606 - _e595) + 0.5f) * _e634));
let _e640 = global_1.member.member_7.member_1;
let _e644 = global_1.member.member_8.member_1;
let _e649 = ((_e640 + (_e644 * _e619)) + (((_e608 - _e604) + 0.5f) * _e634));
let _e653 = global_1.member.member_4.member_1;
let _e654 = (_e653 - _e618);
let _e659 = ((_e623 + (_e627 * _e654)) + ((_e606 + 0.5f) * _e634));
let _e664 = ((_e640 + (_e644 * _e654)) + ((_e608 + 0.5f) * _e634));
let _e668 = global_1.member.member_5.member;
let _e681 = global_1.member.member_5.member.member_3;
let _e682 = ((((_e668.member * _e636) + (_e668.member_1 * _e649)) + (_e668.member_2 * _e614)) + _e681);
let _e686 = global_1.member.member_5.member_1;
let _e699 = global_1.member.member_5.member_1.member_3;
let _e700 = ((((_e686.member * _e636) + (_e686.member_1 * _e649)) + (_e686.member_2 * _e614)) + _e699);
let _e704 = global_1.member.member_5.member_2;
let _e717 = global_1.member.member_5.member_2.member_3;
let _e718 = ((((_e704.member * _e636) + (_e704.member_1 * _e649)) + (_e704.member_2 * _e614)) + _e717);
let _e724 = ((((_e668.member * _e659) + (_e668.member_1 * _e664)) + (_e668.member_2 * _e653)) + _e681);
let _e730 = ((((_e686.member * _e659) + (_e686.member_1 * _e664)) + (_e686.member_2 * _e653)) + _e699);
let _e736 = ((((_e704.member * _e659) + (_e704.member_1 * _e664)) + (_e704.member_2 * _e653)) + _e717);
let _e738 = (_e581 == 2u);
let _e741 = (((_e581 == 1u) || _e738) || (_e581 == 5u));
if _e741 {
let _e1027 = global_1.member.member_5.member_3.member;
let _e1028 = (_e1027 - 0.5f);
let _e1030 = select(-0.5f, _e724, (_e724 > -0.5f));
let _e1032 = select(_e1028, _e1030, (_e1030 < _e1028));
let _e1037 = global_1.member.member_5.member_3.member_1;
let _e1038 = (_e1037 - 0.5f);
let _e1040 = select(-0.5f, _e730, (_e730 > -0.5f));
let _e1042 = select(_e1038, _e1040, (_e1040 < _e1038));
let _e1047 = global_1.member.member_5.member_3.member_2;
let _e1048 = (_e1047 - 0.5f);
let _e1050 = select(-0.5f, _e736, (_e736 > -0.5f));
let _e1052 = select(_e1048, _e1050, (_e1050 < _e1048));
let _e1054 = select(-1f, _e1032, (_e1032 > -1f));
let _e1056 = select(_e1027, _e1054, (_e1054 < _e1027));
let _e1063 = select(0i, select(select(i32(_e1056), i32(-2147483648), (_e1056 < -2147483600f)), 2147483647i, (_e1056 > 2147483500f)), (_e1056 == _e1056));
let _e1067 = (_e1063 - select(0i, 1i, (_e1056 < f32(_e1063))));
let _e1069 = select(-1f, _e1042, (_e1042 > -1f));
let _e1071 = select(_e1037, _e1069, (_e1069 < _e1037));
let _e1078 = select(0i, select(select(i32(_e1071), i32(-2147483648), (_e1071 < -2147483600f)), 2147483647i, (_e1071 > 2147483500f)), (_e1071 == _e1071));
let _e1082 = (_e1078 - select(0i, 1i, (_e1071 < f32(_e1078))));
let _e1084 = select(-1f, _e1052, (_e1052 > -1f));
let _e1086 = select(_e1047, _e1084, (_e1084 < _e1047));
let _e1093 = select(0i, select(select(i32(_e1086), i32(-2147483648), (_e1086 < -2147483600f)), 2147483647i, (_e1086 > 2147483500f)), (_e1086 == _e1086));
let _e1097 = (_e1093 - select(0i, 1i, (_e1086 < f32(_e1093))));
let _e1102 = global_1.member.member_5.member_5[0u];
let _e1107 = global_1.member.member_5.member_5[1u];
let _e1115 = (select(0i, select(select(i32(_e1037), i32(-2147483648), (_e1037 < -2147483600f)), 2147483647i, (_e1037 > 2147483500f)), (_e1037 == _e1037)) - 1i);
let _e1116 = (_e1082 - 1i);
let _e1121 = (_e1082 + 1i);
let _e1124 = (_e1082 + 2i);
let _e1134 = (select(0i, select(select(i32(_e1047), i32(-2147483648), (_e1047 < -2147483600f)), 2147483647i, (_e1047 > 2147483500f)), (_e1047 == _e1047)) - 1i);
let _e1135 = (_e1097 - 1i);
let _e1140 = (_e1097 + 1i);
let _e1143 = (_e1097 + 2i);
let _e1153 = (select(0i, select(select(i32(_e1027), i32(-2147483648), (_e1027 < -2147483600f)), 2147483647i, (_e1027 > 2147483500f)), (_e1027 == _e1027)) - 1i);
let _e1154 = (_e1067 - 1i);
let _e1159 = (_e1067 + 1i);
let _e1162 = (_e1067 + 2i);
let _e1165 = (select(0i, _e1116, (_e1116 > 0i)) * _e1102);
let _e1166 = (select(0i, _e1082, (_e1082 > 0i)) * _e1102);
let _e1167 = (select(_e1115, _e1121, (_e1121 < _e1115)) * _e1102);
let _e1168 = (select(_e1115, _e1124, (_e1124 < _e1115)) * _e1102);
let _e1169 = (select(0i, _e1135, (_e1135 > 0i)) * _e1107);
let _e1170 = (select(0i, _e1097, (_e1097 > 0i)) * _e1107);
let _e1171 = (select(_e1134, _e1140, (_e1140 < _e1134)) * _e1107);
let _e1172 = (select(_e1134, _e1143, (_e1143 < _e1134)) * _e1107);
local_4 = type_18(array<i32, 4>(select(0i, _e1154, (_e1154 > 0i)), select(0i, _e1067, (_e1067 > 0i)), select(_e1153, _e1159, (_e1159 < _e1153)), select(_e1153, _e1162, (_e1162 < _e1153))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_5 = vec3<f32>((_e1032 - f32(_e1067)), (_e1042 - f32(_e1082)), (_e1052 - f32(_e1097)));
let _e1183 = (_e1170 + _e1166);
let _e1186 = local_4.member[0u];
let _e1187 = (_e1183 + _e1186);
let _e1189 = (bitcast<i32>(_e86) - 1i);
let _e1191 = select(_e1189, _e1187, (_e1187 < _e1189));
let _e1196 = global_2.member[bitcast<u32>(select(0i, _e1191, (_e1191 > 0i)))];
let _e1197 = bitcast<f32>(_e1196);
let _e1200 = local_4.member[1u];
let _e1201 = (_e1183 + _e1200);
let _e1203 = select(_e1189, _e1201, (_e1201 < _e1189));
let _e1208 = global_2.member[bitcast<u32>(select(0i, _e1203, (_e1203 > 0i)))];
let _e1209 = bitcast<f32>(_e1208);
let _e1212 = local_4.member[2u];
let _e1213 = (_e1183 + _e1212);
let _e1215 = select(_e1189, _e1213, (_e1213 < _e1189));
let _e1220 = global_2.member[bitcast<u32>(select(0i, _e1215, (_e1215 > 0i)))];
let _e1221 = bitcast<f32>(_e1220);
let _e1224 = local_4.member[3u];
let _e1225 = (_e1183 + _e1224);
let _e1227 = select(_e1189, _e1225, (_e1225 < _e1189));
let _e1232 = global_2.member[bitcast<u32>(select(0i, _e1227, (_e1227 > 0i)))];
let _e1234 = local_5[0u];
let _e1237 = (_e1197 + ((_e1209 - _e1197) * _e1234));
let _e1238 = local_5[0u];
let _e1241 = (_e1209 + ((_e1221 - _e1209) * _e1238));
let _e1242 = local_5[0u];
let _e1245 = (_e1221 + ((bitcast<f32>(_e1232) - _e1221) * _e1242));
let _e1246 = (_e1170 + _e1167);
let _e1247 = local_4.member[0u];
let _e1248 = (_e1246 + _e1247);
let _e1250 = select(_e1189, _e1248, (_e1248 < _e1189));
let _e1255 = global_2.member[bitcast<u32>(select(0i, _e1250, (_e1250 > 0i)))];
let _e1256 = bitcast<f32>(_e1255);
let _e1257 = local_4.member[1u];
let _e1258 = (_e1246 + _e1257);
let _e1260 = select(_e1189, _e1258, (_e1258 < _e1189));
let _e1265 = global_2.member[bitcast<u32>(select(0i, _e1260, (_e1260 > 0i)))];
let _e1266 = bitcast<f32>(_e1265);
let _e1267 = local_4.member[2u];
let _e1268 = (_e1246 + _e1267);
let _e1270 = select(_e1189, _e1268, (_e1268 < _e1189));
let _e1275 = global_2.member[bitcast<u32>(select(0i, _e1270, (_e1270 > 0i)))];
let _e1276 = bitcast<f32>(_e1275);
let _e1277 = local_4.member[3u];
let _e1278 = (_e1246 + _e1277);
let _e1280 = select(_e1189, _e1278, (_e1278 < _e1189));
let _e1285 = global_2.member[bitcast<u32>(select(0i, _e1280, (_e1280 > 0i)))];
let _e1287 = local_5[0u];
let _e1291 = local_5[0u];
let _e1294 = (_e1266 + ((_e1276 - _e1266) * _e1291));
let _e1295 = local_5[0u];
let _e1299 = (_e1171 + _e1166);
let _e1300 = local_4.member[0u];
let _e1301 = (_e1299 + _e1300);
let _e1303 = select(_e1189, _e1301, (_e1301 < _e1189));
let _e1308 = global_2.member[bitcast<u32>(select(0i, _e1303, (_e1303 > 0i)))];
let _e1309 = bitcast<f32>(_e1308);
let _e1310 = local_4.member[1u];
let _e1311 = (_e1299 + _e1310);
let _e1313 = select(_e1189, _e1311, (_e1311 < _e1189));
let _e1318 = global_2.member[bitcast<u32>(select(0i, _e1313, (_e1313 > 0i)))];
let _e1319 = bitcast<f32>(_e1318);
let _e1320 = local_4.member[2u];
let _e1321 = (_e1299 + _e1320);
let _e1323 = select(_e1189, _e1321, (_e1321 < _e1189));
let _e1328 = global_2.member[bitcast<u32>(select(0i, _e1323, (_e1323 > 0i)))];
let _e1329 = bitcast<f32>(_e1328);
let _e1330 = local_4.member[3u];
let _e1331 = (_e1299 + _e1330);
let _e1333 = select(_e1189, _e1331, (_e1331 < _e1189));
let _e1338 = global_2.member[bitcast<u32>(select(0i, _e1333, (_e1333 > 0i)))];
let _e1340 = local_5[0u];
let _e1343 = (_e1309 + ((_e1319 - _e1309) * _e1340));
let _e1344 = local_5[0u];
let _e1347 = (_e1319 + ((_e1329 - _e1319) * _e1344));
let _e1348 = local_5[0u];
let _e1351 = (_e1329 + ((bitcast<f32>(_e1338) - _e1329) * _e1348));
let _e1352 = (_e1171 + _e1167);
let _e1353 = local_4.member[0u];
let _e1354 = (_e1352 + _e1353);
let _e1356 = select(_e1189, _e1354, (_e1354 < _e1189));
let _e1361 = global_2.member[bitcast<u32>(select(0i, _e1356, (_e1356 > 0i)))];
let _e1362 = bitcast<f32>(_e1361);
let _e1363 = local_4.member[1u];
let _e1364 = (_e1352 + _e1363);
let _e1366 = select(_e1189, _e1364, (_e1364 < _e1189));
let _e1371 = global_2.member[bitcast<u32>(select(0i, _e1366, (_e1366 > 0i)))];
let _e1372 = bitcast<f32>(_e1371);
let _e1373 = local_4.member[2u];
let _e1374 = (_e1352 + _e1373);
let _e1376 = select(_e1189, _e1374, (_e1374 < _e1189));
let _e1381 = global_2.member[bitcast<u32>(select(0i, _e1376, (_e1376 > 0i)))];
let _e1382 = bitcast<f32>(_e1381);
let _e1383 = local_4.member[3u];
let _e1384 = (_e1352 + _e1383);
let _e1386 = select(_e1189, _e1384, (_e1384 < _e1189));
let _e1391 = global_2.member[bitcast<u32>(select(0i, _e1386, (_e1386 > 0i)))];
let _e1393 = local_5[0u];
let _e1397 = local_5[0u];
let _e1400 = (_e1372 + ((_e1382 - _e1372) * _e1397));
let _e1401 = local_5[0u];
let _e1405 = (_e1170 + _e1165);
let _e1406 = local_4.member[1u];
let _e1407 = (_e1405 + _e1406);
let _e1409 = select(_e1189, _e1407, (_e1407 < _e1189));
let _e1414 = global_2.member[bitcast<u32>(select(0i, _e1409, (_e1409 > 0i)))];
let _e1415 = bitcast<f32>(_e1414);
let _e1416 = local_4.member[2u];
let _e1417 = (_e1405 + _e1416);
let _e1419 = select(_e1189, _e1417, (_e1417 < _e1189));
let _e1424 = global_2.member[bitcast<u32>(select(0i, _e1419, (_e1419 > 0i)))];
let _e1426 = local_5[0u];
let _e1429 = (_e1415 + ((bitcast<f32>(_e1424) - _e1415) * _e1426));
let _e1430 = (_e1170 + _e1168);
let _e1431 = local_4.member[1u];
let _e1432 = (_e1430 + _e1431);
let _e1434 = select(_e1189, _e1432, (_e1432 < _e1189));
let _e1439 = global_2.member[bitcast<u32>(select(0i, _e1434, (_e1434 > 0i)))];
let _e1440 = bitcast<f32>(_e1439);
let _e1441 = local_4.member[2u];
let _e1442 = (_e1430 + _e1441);
let _e1444 = select(_e1189, _e1442, (_e1442 < _e1189));
let _e1449 = global_2.member[bitcast<u32>(select(0i, _e1444, (_e1444 > 0i)))];
let _e1451 = local_5[0u];
let _e1455 = (_e1171 + _e1165);
let _e1456 = local_4.member[1u];
let _e1457 = (_e1455 + _e1456);
let _e1459 = select(_e1189, _e1457, (_e1457 < _e1189));
let _e1464 = global_2.member[bitcast<u32>(select(0i, _e1459, (_e1459 > 0i)))];
let _e1465 = bitcast<f32>(_e1464);
let _e1466 = local_4.member[2u];
let _e1467 = (_e1455 + _e1466);
let _e1469 = select(_e1189, _e1467, (_e1467 < _e1189));
let _e1474 = global_2.member[bitcast<u32>(select(0i, _e1469, (_e1469 > 0i)))];
let _e1476 = local_5[0u];
let _e1479 = (_e1465 + ((bitcast<f32>(_e1474) - _e1465) * _e1476));
let _e1480 = (_e1171 + _e1168);
let _e1481 = local_4.member[1u];
let _e1482 = (_e1480 + _e1481);
let _e1484 = select(_e1189, _e1482, (_e1482 < _e1189));
let _e1489 = global_2.member[bitcast<u32>(select(0i, _e1484, (_e1484 > 0i)))];
let _e1490 = bitcast<f32>(_e1489);
let _e1491 = local_4.member[2u];
let _e1492 = (_e1480 + _e1491);
let _e1494 = select(_e1189, _e1492, (_e1492 < _e1189));
let _e1499 = global_2.member[bitcast<u32>(select(0i, _e1494, (_e1494 > 0i)))];
let _e1501 = local_5[0u];
let _e1505 = (_e1169 + _e1166);
let _e1506 = local_4.member[1u];
let _e1507 = (_e1505 + _e1506);
let _e1509 = select(_e1189, _e1507, (_e1507 < _e1189));
let _e1514 = global_2.member[bitcast<u32>(select(0i, _e1509, (_e1509 > 0i)))];
let _e1515 = bitcast<f32>(_e1514);
let _e1516 = local_4.member[2u];
let _e1517 = (_e1505 + _e1516);
let _e1519 = select(_e1189, _e1517, (_e1517 < _e1189));
let _e1524 = global_2.member[bitcast<u32>(select(0i, _e1519, (_e1519 > 0i)))];
let _e1526 = local_5[0u];
let _e1529 = (_e1515 + ((bitcast<f32>(_e1524) - _e1515) * _e1526));
let _e1530 = (_e1172 + _e1166);
let _e1531 = local_4.member[1u];
let _e1532 = (_e1530 + _e1531);
let _e1534 = select(_e1189, _e1532, (_e1532 < _e1189));
let _e1539 = global_2.member[bitcast<u32>(select(0i, _e1534, (_e1534 > 0i)))];
let _e1540 = bitcast<f32>(_e1539);
let _e1541 = local_4.member[2u];
let _e1542 = (_e1530 + _e1541);
let _e1544 = select(_e1189, _e1542, (_e1542 < _e1189));
let _e1549 = global_2.member[bitcast<u32>(select(0i, _e1544, (_e1544 > 0i)))];
let _e1551 = local_5[0u];
let _e1554 = (_e1540 + ((bitcast<f32>(_e1549) - _e1540) * _e1551));
let _e1555 = (_e1169 + _e1167);
let _e1556 = local_4.member[1u];
let _e1557 = (_e1555 + _e1556);
let _e1559 = select(_e1189, _e1557, (_e1557 < _e1189));
let _e1564 = global_2.member[bitcast<u32>(select(0i, _e1559, (_e1559 > 0i)))];
let _e1565 = bitcast<f32>(_e1564);
let _e1566 = local_4.member[2u];
let _e1567 = (_e1555 + _e1566);
let _e1569 = select(_e1189, _e1567, (_e1567 < _e1189));
let _e1574 = global_2.member[bitcast<u32>(select(0i, _e1569, (_e1569 > 0i)))];
let _e1576 = local_5[0u];
let _e1580 = (_e1172 + _e1167);
let _e1581 = local_4.member[1u];
let _e1582 = (_e1580 + _e1581);
let _e1584 = select(_e1189, _e1582, (_e1582 < _e1189));
let _e1589 = global_2.member[bitcast<u32>(select(0i, _e1584, (_e1584 > 0i)))];
let _e1590 = bitcast<f32>(_e1589);
let _e1591 = local_4.member[2u];
let _e1592 = (_e1580 + _e1591);
let _e1594 = select(_e1189, _e1592, (_e1592 < _e1189));
let _e1599 = global_2.member[bitcast<u32>(select(0i, _e1594, (_e1594 > 0i)))];
let _e1601 = local_5[0u];
let _e1606 = local_5[1u];
let _e1609 = (_e1241 + ((_e1294 - _e1241) * _e1606));
let _e1610 = local_5[1u];
let _e1613 = (_e1347 + ((_e1400 - _e1347) * _e1610));
let _e1614 = local_5[1u];
let _e1617 = (_e1237 + (((_e1256 + ((_e1266 - _e1256) * _e1287)) - _e1237) * _e1614));
let _e1618 = local_5[1u];
let _e1623 = local_5[2u];
let _e1627 = local_5[1u];
let _e1630 = (_e1245 + (((_e1276 + ((bitcast<f32>(_e1285) - _e1276) * _e1295)) - _e1245) * _e1627));
let _e1631 = local_5[1u];
let _e1635 = local_5[2u];
let _e1639 = local_5[1u];
let _e1642 = (_e1429 + ((_e1241 - _e1429) * _e1639));
let _e1643 = local_5[1u];
let _e1647 = local_5[2u];
let _e1651 = local_5[1u];
let _e1654 = (_e1294 + (((_e1440 + ((bitcast<f32>(_e1449) - _e1440) * _e1451)) - _e1294) * _e1651));
let _e1655 = local_5[1u];
let _e1659 = local_5[2u];
let _e1663 = local_5[1u];
let _e1666 = (_e1529 + (((_e1565 + ((bitcast<f32>(_e1574) - _e1565) * _e1576)) - _e1529) * _e1663));
let _e1667 = local_5[2u];
let _e1671 = local_5[1u];
let _e1675 = local_5[2u];
let _e1679 = local_5[2u];
let _e1687 = global_1.member.member_5.member_4.member;
let _e1693 = global_1.member.member_5.member_4.member_1;
let _e1694 = (((_e1609 + ((_e1613 - _e1609) * _e1679)) * _e1687) + _e1693);
let _e1696 = select(0f, _e1694, (_e1694 > 0f));
let _e1698 = select(1f, _e1696, (_e1696 < 1f));
let _e1700 = (((_e1617 + (((_e1343 + (((_e1362 + ((_e1372 - _e1362) * _e1393)) - _e1343) * _e1618)) - _e1617) * _e1623)) * _e1687) + _e1693);
let _e1702 = select(0f, _e1700, (_e1700 > 0f));
let _e1704 = select(1f, _e1702, (_e1702 < 1f));
let _e1706 = (((_e1630 + (((_e1351 + (((_e1382 + ((bitcast<f32>(_e1391) - _e1382) * _e1401)) - _e1351) * _e1631)) - _e1630) * _e1635)) * _e1687) + _e1693);
let _e1708 = select(0f, _e1706, (_e1706 > 0f));
let _e1710 = select(1f, _e1708, (_e1708 < 1f));
let _e1712 = (((_e1642 + (((_e1479 + ((_e1347 - _e1479) * _e1643)) - _e1642) * _e1647)) * _e1687) + _e1693);
let _e1714 = select(0f, _e1712, (_e1712 > 0f));
let _e1716 = select(1f, _e1714, (_e1714 < 1f));
let _e1718 = (((_e1654 + (((_e1400 + (((_e1490 + ((bitcast<f32>(_e1499) - _e1490) * _e1501)) - _e1400) * _e1655)) - _e1654) * _e1659)) * _e1687) + _e1693);
let _e1720 = select(0f, _e1718, (_e1718 > 0f));
let _e1722 = select(1f, _e1720, (_e1720 < 1f));
let _e1724 = (((_e1666 + ((_e1609 - _e1666) * _e1667)) * _e1687) + _e1693);
let _e1726 = select(0f, _e1724, (_e1724 > 0f));
let _e1728 = select(1f, _e1726, (_e1726 < 1f));
let _e1730 = (((_e1613 + (((_e1554 + (((_e1590 + ((bitcast<f32>(_e1599) - _e1590) * _e1601)) - _e1554) * _e1671)) - _e1613) * _e1675)) * _e1687) + _e1693);
let _e1732 = select(0f, _e1730, (_e1730 > 0f));
let _e1734 = select(1f, _e1732, (_e1732 < 1f));
let _e1735 = (_e1698 * 1024f);
let _e1736 = (1024f - 1f);
let _e1738 = select(0f, _e1735, (_e1735 > 0f));
let _e1740 = select(_e1736, _e1738, (_e1738 < _e1736));
let _e1747 = select(0i, select(select(i32(_e1740), i32(-2147483648), (_e1740 < -2147483600f)), 2147483647i, (_e1740 > 2147483500f)), (_e1740 == _e1740));
let _e1751 = (_e1747 - select(0i, 1i, (_e1740 < f32(_e1747))));
let _e1752 = (262147i + _e1751);
let _e1754 = (bitcast<i32>(_e90) - 1i);
let _e1756 = select(_e1754, _e1752, (_e1752 < _e1754));
let _e1762 = global_4.member[bitcast<u32>(select(0i, _e1756, (_e1756 > 0i)))];
let _e1772 = select(_e1754, 262146i, (262146i < _e1754));
let _e1778 = global_4.member[bitcast<u32>(select(0i, _e1772, (_e1772 > 0i)))];
let _e1779 = bitcast<f32>(_e1778);
let _e1780 = (f32((bitcast<i32>((_e1762 & 4095u)) - 2048i)) * _e1779);
let _e1782 = select(_e1754, 262144i, (262144i < _e1754));
let _e1788 = global_4.member[bitcast<u32>(select(0i, _e1782, (_e1782 > 0i)))];
let _e1789 = bitcast<f32>(_e1788);
let _e1791 = select(_e1754, 262145i, (262145i < _e1754));
let _e1797 = global_4.member[bitcast<u32>(select(0i, _e1791, (_e1791 > 0i)))];
let _e1798 = bitcast<f32>(_e1797);
let _e1804 = ((_e1789 + (f32(bitcast<i32>((_e1762 >> bitcast<u32>(12u)))) * _e1798)) + (_e1780 * (_e1735 - f32(_e1751))));
let _e1805 = (_e1780 * 1024f);
if _e738 {
let _e2070 = ((0.5f * (_e1710 - _e1704)) * _e1805);
let _e2071 = ((0.5f * (_e1722 - _e1716)) * _e1805);
let _e2072 = ((0.5f * (_e1734 - _e1728)) * _e1805);
phi_5327_ = type_19(_e1804, vec3<f32>(_e2070, _e2071, _e2072), vec3<f32>((_e2070 * _e1804), (_e2071 * _e1804), (_e2072 * _e1804)));
} else {
let _e1806 = (_e1704 * 1024f);
let _e1808 = select(0f, _e1806, (_e1806 > 0f));
let _e1810 = select(_e1736, _e1808, (_e1808 < _e1736));
let _e1817 = select(0i, select(select(i32(_e1810), i32(-2147483648), (_e1810 < -2147483600f)), 2147483647i, (_e1810 > 2147483500f)), (_e1810 == _e1810));
let _e1821 = (_e1817 - select(0i, 1i, (_e1810 < f32(_e1817))));
let _e1822 = (262147i + _e1821);
let _e1824 = select(_e1754, _e1822, (_e1822 < _e1754));
let _e1830 = global_4.member[bitcast<u32>(select(0i, _e1824, (_e1824 > 0i)))];
let _e1845 = ((_e1789 + (f32(bitcast<i32>((_e1830 >> bitcast<u32>(12u)))) * _e1798)) + ((f32((bitcast<i32>((_e1830 & 4095u)) - 2048i)) * _e1779) * (_e1806 - f32(_e1821))));
let _e1846 = (_e1710 * 1024f);
let _e1848 = select(0f, _e1846, (_e1846 > 0f));
let _e1850 = select(_e1736, _e1848, (_e1848 < _e1736));
let _e1857 = select(0i, select(select(i32(_e1850), i32(-2147483648), (_e1850 < -2147483600f)), 2147483647i, (_e1850 > 2147483500f)), (_e1850 == _e1850));
let _e1861 = (_e1857 - select(0i, 1i, (_e1850 < f32(_e1857))));
let _e1862 = (262147i + _e1861);
let _e1864 = select(_e1754, _e1862, (_e1862 < _e1754));
let _e1870 = global_4.member[bitcast<u32>(select(0i, _e1864, (_e1864 > 0i)))];
let _e1885 = ((_e1789 + (f32(bitcast<i32>((_e1870 >> bitcast<u32>(12u)))) * _e1798)) + ((f32((bitcast<i32>((_e1870 & 4095u)) - 2048i)) * _e1779) * (_e1846 - f32(_e1861))));
let _e1886 = (_e1716 * 1024f);
let _e1888 = select(0f, _e1886, (_e1886 > 0f));
let _e1890 = select(_e1736, _e1888, (_e1888 < _e1736));
let _e1897 = select(0i, select(select(i32(_e1890), i32(-2147483648), (_e1890 < -2147483600f)), 2147483647i, (_e1890 > 2147483500f)), (_e1890 == _e1890));
let _e1901 = (_e1897 - select(0i, 1i, (_e1890 < f32(_e1897))));
let _e1902 = (262147i + _e1901);
let _e1904 = select(_e1754, _e1902, (_e1902 < _e1754));
let _e1910 = global_4.member[bitcast<u32>(select(0i, _e1904, (_e1904 > 0i)))];
let _e1925 = ((_e1789 + (f32(bitcast<i32>((_e1910 >> bitcast<u32>(12u)))) * _e1798)) + ((f32((bitcast<i32>((_e1910 & 4095u)) - 2048i)) * _e1779) * (_e1886 - f32(_e1901))));
let _e1926 = (_e1722 * 1024f);
let _e1928 = select(0f, _e1926, (_e1926 > 0f));
let _e1930 = select(_e1736, _e1928, (_e1928 < _e1736));
let _e1937 = select(0i, select(select(i32(_e1930), i32(-2147483648), (_e1930 < -2147483600f)), 2147483647i, (_e1930 > 2147483500f)), (_e1930 == _e1930));
let _e1941 = (_e1937 - select(0i, 1i, (_e1930 < f32(_e1937))));
let _e1942 = (262147i + _e1941);
let _e1944 = select(_e1754, _e1942, (_e1942 < _e1754));
let _e1950 = global_4.member[bitcast<u32>(select(0i, _e1944, (_e1944 > 0i)))];
let _e1965 = ((_e1789 + (f32(bitcast<i32>((_e1950 >> bitcast<u32>(12u)))) * _e1798)) + ((f32((bitcast<i32>((_e1950 & 4095u)) - 2048i)) * _e1779) * (_e1926 - f32(_e1941))));
let _e1966 = (_e1728 * 1024f);
let _e1968 = select(0f, _e1966, (_e1966 > 0f));
let _e1970 = select(_e1736, _e1968, (_e1968 < _e1736));
let _e1977 = select(0i, select(select(i32(_e1970), i32(-2147483648), (_e1970 < -2147483600f)), 2147483647i, (_e1970 > 2147483500f)), (_e1970 == _e1970));
let _e1981 = (_e1977 - select(0i, 1i, (_e1970 < f32(_e1977))));
let _e1982 = (262147i + _e1981);
let _e1984 = select(_e1754, _e1982, (_e1982 < _e1754));
let _e1990 = global_4.member[bitcast<u32>(select(0i, _e1984, (_e1984 > 0i)))];
let _e2005 = ((_e1789 + (f32(bitcast<i32>((_e1990 >> bitcast<u32>(12u)))) * _e1798)) + ((f32((bitcast<i32>((_e1990 & 4095u)) - 2048i)) * _e1779) * (_e1966 - f32(_e1981))));
let _e2006 = (_e1734 * 1024f);
let _e2008 = select(0f, _e2006, (_e2006 > 0f));
let _e2010 = select(_e1736, _e2008, (_e2008 < _e1736));
let _e2017 = select(0i, select(select(i32(_e2010), i32(-2147483648), (_e2010 < -2147483600f)), 2147483647i, (_e2010 > 2147483500f)), (_e2010 == _e2010));
let _e2021 = (_e2017 - select(0i, 1i, (_e2010 < f32(_e2017))));
let _e2022 = (262147i + _e2021);
let _e2024 = select(_e1754, _e2022, (_e2022 < _e1754));
let _e2030 = global_4.member[bitcast<u32>(select(0i, _e2024, (_e2024 > 0i)))];
let _e2045 = ((_e1789 + (f32(bitcast<i32>((_e2030 >> bitcast<u32>(12u)))) * _e1798)) + ((f32((bitcast<i32>((_e2030 & 4095u)) - 2048i)) * _e1779) * (_e2006 - f32(_e2021))));
let _e2046 = (_e1885 - _e1845);
let _e2048 = (_e1965 - _e1925);
let _e2050 = (_e2045 - _e2005);
phi_5327_ = type_19(_e1804, vec3<f32>((0.5f * _e2046), (0.5f * _e2048), (0.5f * _e2050)), vec3<f32>((0.25f * (_e2046 * (_e1885 + _e1845))), (0.25f * (_e2048 * (_e1965 + _e1925))), (0.25f * (_e2050 * (_e2045 + _e2005)))));
}
let _e2080 = phi_5327_;
let _e2095 = select(0f, 1f, ((((((_e724 >= -0.5f) && (_e724 <= _e1028)) && (_e730 >= -0.5f)) && (_e730 <= _e1038)) && (_e736 >= -0.5f)) && (_e736 <= _e1048)));
let _e2097 = (0.5f * (_e1710 - _e1704));
let _e2099 = (0.5f * (_e1722 - _e1716));
let _e2101 = (0.5f * (_e1734 - _e1728));
let _e2106 = global_1.member.member_5.member.member;
let _e2112 = global_1.member.member_5.member_1.member;
let _e2119 = global_1.member.member_5.member_2.member;
let _e2126 = global_1.member.member_5.member.member_1;
let _e2132 = global_1.member.member_5.member_1.member_1;
let _e2139 = global_1.member.member_5.member_2.member_1;
let _e2146 = global_1.member.member_5.member.member_2;
let _e2152 = global_1.member.member_5.member_1.member_2;
let _e2159 = global_1.member.member_5.member_2.member_2;
phi_6647_ = type_20(_e1698, vec3<f32>(((((_e2106 * _e2097) + (_e2112 * _e2099)) + (_e2119 * _e2101)) * _e2095), ((((_e2126 * _e2097) + (_e2132 * _e2099)) + (_e2139 * _e2101)) * _e2095), ((((_e2146 * _e2097) + (_e2152 * _e2099)) + (_e2159 * _e2101)) * _e2095)), _e2080.member, vec3<f32>(((((_e2106 * _e2080.member_2.x) + (_e2112 * _e2080.member_2.y)) + (_e2119 * _e2080.member_2.z)) * _e2095), ((((_e2126 * _e2080.member_2.x) + (_e2132 * _e2080.member_2.y)) + (_e2139 * _e2080.member_2.z)) * _e2095), ((((_e2146 * _e2080.member_2.x) + (_e2152 * _e2080.member_2.y)) + (_e2159 * _e2080.member_2.z)) * _e2095)), vec3<f32>(((((_e2106 * _e2080.member_1.x) + (_e2112 * _e2080.member_1.y)) + (_e2119 * _e2080.member_1.z)) * _e2095), ((((_e2126 * _e2080.member_1.x) + (_e2132 * _e2080.member_1.y)) + (_e2139 * _e2080.member_1.z)) * _e2095), ((((_e2146 * _e2080.member_1.x) + (_e2152 * _e2080.member_1.y)) + (_e2159 * _e2080.member_1.z)) * _e2095)));
} else {
let _e746 = global_1.member.member_5.member_3.member;
let _e747 = (_e746 - 0.5f);
let _e749 = select(-0.5f, _e724, (_e724 > -0.5f));
let _e751 = select(_e747, _e749, (_e749 < _e747));
let _e756 = global_1.member.member_5.member_3.member_1;
let _e757 = (_e756 - 0.5f);
let _e759 = select(-0.5f, _e730, (_e730 > -0.5f));
let _e761 = select(_e757, _e759, (_e759 < _e757));
let _e766 = global_1.member.member_5.member_3.member_2;
let _e767 = (_e766 - 0.5f);
let _e769 = select(-0.5f, _e736, (_e736 > -0.5f));
let _e771 = select(_e767, _e769, (_e769 < _e767));
let _e773 = select(-1f, _e751, (_e751 > -1f));
let _e775 = select(_e746, _e773, (_e773 < _e746));
let _e782 = select(0i, select(select(i32(_e775), i32(-2147483648), (_e775 < -2147483600f)), 2147483647i, (_e775 > 2147483500f)), (_e775 == _e775));
let _e786 = (_e782 - select(0i, 1i, (_e775 < f32(_e782))));
let _e788 = select(-1f, _e761, (_e761 > -1f));
let _e790 = select(_e756, _e788, (_e788 < _e756));
let _e797 = select(0i, select(select(i32(_e790), i32(-2147483648), (_e790 < -2147483600f)), 2147483647i, (_e790 > 2147483500f)), (_e790 == _e790));
let _e801 = (_e797 - select(0i, 1i, (_e790 < f32(_e797))));
let _e803 = select(-1f, _e771, (_e771 > -1f));
let _e805 = select(_e766, _e803, (_e803 < _e766));
let _e812 = select(0i, select(select(i32(_e805), i32(-2147483648), (_e805 < -2147483600f)), 2147483647i, (_e805 > 2147483500f)), (_e805 == _e805));
let _e816 = (_e812 - select(0i, 1i, (_e805 < f32(_e812))));
let _e821 = global_1.member.member_5.member_5[0u];
let _e826 = global_1.member.member_5.member_5[1u];
let _e834 = (select(0i, select(select(i32(_e756), i32(-2147483648), (_e756 < -2147483600f)), 2147483647i, (_e756 > 2147483500f)), (_e756 == _e756)) - 1i);
let _e837 = (_e801 + 1i);
let _e847 = (select(0i, select(select(i32(_e766), i32(-2147483648), (_e766 < -2147483600f)), 2147483647i, (_e766 > 2147483500f)), (_e766 == _e766)) - 1i);
let _e850 = (_e816 + 1i);
let _e860 = (select(0i, select(select(i32(_e746), i32(-2147483648), (_e746 < -2147483600f)), 2147483647i, (_e746 > 2147483500f)), (_e746 == _e746)) - 1i);
let _e861 = (_e786 - 1i);
let _e866 = (_e786 + 1i);
let _e869 = (_e786 + 2i);
let _e872 = (select(0i, _e801, (_e801 > 0i)) * _e821);
let _e873 = (select(_e834, _e837, (_e837 < _e834)) * _e821);
let _e874 = (select(0i, _e816, (_e816 > 0i)) * _e826);
let _e875 = (select(_e847, _e850, (_e850 < _e847)) * _e826);
local_2 = type_18(array<i32, 4>(select(0i, _e861, (_e861 > 0i)), select(0i, _e786, (_e786 > 0i)), select(_e860, _e866, (_e866 < _e860)), select(_e860, _e869, (_e869 < _e860))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = vec3<f32>((_e751 - f32(_e786)), (_e761 - f32(_e801)), (_e771 - f32(_e816)));
let _e886 = (_e874 + _e872);
let _e889 = local_2.member[1u];
let _e890 = (_e886 + _e889);
let _e892 = (bitcast<i32>(_e86) - 1i);
let _e894 = select(_e892, _e890, (_e890 < _e892));
let _e899 = global_2.member[bitcast<u32>(select(0i, _e894, (_e894 > 0i)))];
let _e900 = bitcast<f32>(_e899);
let _e903 = local_2.member[2u];
let _e904 = (_e886 + _e903);
let _e906 = select(_e892, _e904, (_e904 < _e892));
let _e911 = global_2.member[bitcast<u32>(select(0i, _e906, (_e906 > 0i)))];
let _e913 = local_3[0u];
let _e916 = (_e900 + ((bitcast<f32>(_e911) - _e900) * _e913));
let _e917 = (_e874 + _e873);
let _e918 = local_2.member[1u];
let _e919 = (_e917 + _e918);
let _e921 = select(_e892, _e919, (_e919 < _e892));
let _e926 = global_2.member[bitcast<u32>(select(0i, _e921, (_e921 > 0i)))];
let _e927 = bitcast<f32>(_e926);
let _e928 = local_2.member[2u];
let _e929 = (_e917 + _e928);
let _e931 = select(_e892, _e929, (_e929 < _e892));
let _e936 = global_2.member[bitcast<u32>(select(0i, _e931, (_e931 > 0i)))];
let _e938 = local_3[0u];
let _e943 = local_3[1u];
let _e946 = (_e916 + (((_e927 + ((bitcast<f32>(_e936) - _e927) * _e938)) - _e916) * _e943));
let _e947 = (_e875 + _e872);
let _e948 = local_2.member[1u];
let _e949 = (_e947 + _e948);
let _e951 = select(_e892, _e949, (_e949 < _e892));
let _e956 = global_2.member[bitcast<u32>(select(0i, _e951, (_e951 > 0i)))];
let _e957 = bitcast<f32>(_e956);
let _e958 = local_2.member[2u];
let _e959 = (_e947 + _e958);
let _e961 = select(_e892, _e959, (_e959 < _e892));
let _e966 = global_2.member[bitcast<u32>(select(0i, _e961, (_e961 > 0i)))];
let _e968 = local_3[0u];
let _e971 = (_e957 + ((bitcast<f32>(_e966) - _e957) * _e968));
let _e972 = (_e875 + _e873);
let _e973 = local_2.member[1u];
let _e974 = (_e972 + _e973);
let _e976 = select(_e892, _e974, (_e974 < _e892));
let _e981 = global_2.member[bitcast<u32>(select(0i, _e976, (_e976 > 0i)))];
let _e982 = bitcast<f32>(_e981);
let _e983 = local_2.member[2u];
let _e984 = (_e972 + _e983);
let _e986 = select(_e892, _e984, (_e984 < _e892));
let _e991 = global_2.member[bitcast<u32>(select(0i, _e986, (_e986 > 0i)))];
let _e993 = local_3[0u];
let _e997 = local_3[1u];
let _e1002 = local_3[2u];
let _e1010 = global_1.member.member_5.member_4.member;
let _e1016 = global_1.member.member_5.member_4.member_1;
let _e1017 = (((_e946 + (((_e971 + (((_e982 + ((bitcast<f32>(_e991) - _e982) * _e993)) - _e971) * _e997)) - _e946) * _e1002)) * _e1010) + _e1016);
let _e1019 = select(0f, _e1017, (_e1017 > 0f));
phi_6647_ = type_20(select(1f, _e1019, (_e1019 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2212 = phi_6647_;
let _e2217 = global_1.member.member_5.member_3.member;
let _e2218 = (_e2217 - 0.5f);
let _e2220 = select(-0.5f, _e682, (_e682 > -0.5f));
let _e2222 = select(_e2218, _e2220, (_e2220 < _e2218));
let _e2227 = global_1.member.member_5.member_3.member_1;
let _e2228 = (_e2227 - 0.5f);
let _e2230 = select(-0.5f, _e700, (_e700 > -0.5f));
let _e2232 = select(_e2228, _e2230, (_e2230 < _e2228));
let _e2237 = global_1.member.member_5.member_3.member_2;
let _e2238 = (_e2237 - 0.5f);
let _e2240 = select(-0.5f, _e718, (_e718 > -0.5f));
let _e2242 = select(_e2238, _e2240, (_e2240 < _e2238));
let _e2244 = select(-1f, _e2222, (_e2222 > -1f));
let _e2246 = select(_e2217, _e2244, (_e2244 < _e2217));
let _e2253 = select(0i, select(select(i32(_e2246), i32(-2147483648), (_e2246 < -2147483600f)), 2147483647i, (_e2246 > 2147483500f)), (_e2246 == _e2246));
let _e2257 = (_e2253 - select(0i, 1i, (_e2246 < f32(_e2253))));
let _e2259 = select(-1f, _e2232, (_e2232 > -1f));
let _e2261 = select(_e2227, _e2259, (_e2259 < _e2227));
let _e2268 = select(0i, select(select(i32(_e2261), i32(-2147483648), (_e2261 < -2147483600f)), 2147483647i, (_e2261 > 2147483500f)), (_e2261 == _e2261));
let _e2272 = (_e2268 - select(0i, 1i, (_e2261 < f32(_e2268))));
let _e2274 = select(-1f, _e2242, (_e2242 > -1f));
let _e2276 = select(_e2237, _e2274, (_e2274 < _e2237));
let _e2283 = select(0i, select(select(i32(_e2276), i32(-2147483648), (_e2276 < -2147483600f)), 2147483647i, (_e2276 > 2147483500f)), (_e2276 == _e2276));
let _e2287 = (_e2283 - select(0i, 1i, (_e2276 < f32(_e2283))));
let _e2292 = global_1.member.member_5.member_5[0u];
let _e2297 = global_1.member.member_5.member_5[1u];
let _e2305 = (select(0i, select(select(i32(_e2227), i32(-2147483648), (_e2227 < -2147483600f)), 2147483647i, (_e2227 > 2147483500f)), (_e2227 == _e2227)) - 1i);
let _e2308 = (_e2272 + 1i);
let _e2318 = (select(0i, select(select(i32(_e2237), i32(-2147483648), (_e2237 < -2147483600f)), 2147483647i, (_e2237 > 2147483500f)), (_e2237 == _e2237)) - 1i);
let _e2321 = (_e2287 + 1i);
let _e2331 = (select(0i, select(select(i32(_e2217), i32(-2147483648), (_e2217 < -2147483600f)), 2147483647i, (_e2217 > 2147483500f)), (_e2217 == _e2217)) - 1i);
let _e2332 = (_e2257 - 1i);
let _e2337 = (_e2257 + 1i);
let _e2340 = (_e2257 + 2i);
let _e2343 = (select(0i, _e2272, (_e2272 > 0i)) * _e2292);
let _e2344 = (select(_e2305, _e2308, (_e2308 < _e2305)) * _e2292);
let _e2345 = (select(0i, _e2287, (_e2287 > 0i)) * _e2297);
let _e2346 = (select(_e2318, _e2321, (_e2321 < _e2318)) * _e2297);
local = type_18(array<i32, 4>(select(0i, _e2332, (_e2332 > 0i)), select(0i, _e2257, (_e2257 > 0i)), select(_e2331, _e2337, (_e2337 < _e2331)), select(_e2331, _e2340, (_e2340 < _e2331))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_1 = vec3<f32>((_e2222 - f32(_e2257)), (_e2232 - f32(_e2272)), (_e2242 - f32(_e2287)));
let _e2357 = (_e2345 + _e2343);
let _e2360 = local.member[1u];
let _e2361 = (_e2357 + _e2360);
let _e2363 = (bitcast<i32>(_e86) - 1i);
let _e2365 = select(_e2363, _e2361, (_e2361 < _e2363));
let _e2370 = global_2.member[bitcast<u32>(select(0i, _e2365, (_e2365 > 0i)))];
let _e2371 = bitcast<f32>(_e2370);
let _e2374 = local.member[2u];
let _e2375 = (_e2357 + _e2374);
let _e2377 = select(_e2363, _e2375, (_e2375 < _e2363));
let _e2382 = global_2.member[bitcast<u32>(select(0i, _e2377, (_e2377 > 0i)))];
let _e2384 = local_1[0u];
let _e2387 = (_e2371 + ((bitcast<f32>(_e2382) - _e2371) * _e2384));
let _e2388 = (_e2345 + _e2344);
let _e2389 = local.member[1u];
let _e2390 = (_e2388 + _e2389);
let _e2392 = select(_e2363, _e2390, (_e2390 < _e2363));
let _e2397 = global_2.member[bitcast<u32>(select(0i, _e2392, (_e2392 > 0i)))];
let _e2398 = bitcast<f32>(_e2397);
let _e2399 = local.member[2u];
let _e2400 = (_e2388 + _e2399);
let _e2402 = select(_e2363, _e2400, (_e2400 < _e2363));
let _e2407 = global_2.member[bitcast<u32>(select(0i, _e2402, (_e2402 > 0i)))];
let _e2409 = local_1[0u];
let _e2414 = local_1[1u];
let _e2417 = (_e2387 + (((_e2398 + ((bitcast<f32>(_e2407) - _e2398) * _e2409)) - _e2387) * _e2414));
let _e2418 = (_e2346 + _e2343);
let _e2419 = local.member[1u];
let _e2420 = (_e2418 + _e2419);
let _e2422 = select(_e2363, _e2420, (_e2420 < _e2363));
let _e2427 = global_2.member[bitcast<u32>(select(0i, _e2422, (_e2422 > 0i)))];
let _e2428 = bitcast<f32>(_e2427);
let _e2429 = local.member[2u];
let _e2430 = (_e2418 + _e2429);
let _e2432 = select(_e2363, _e2430, (_e2430 < _e2363));
let _e2437 = global_2.member[bitcast<u32>(select(0i, _e2432, (_e2432 > 0i)))];
let _e2439 = local_1[0u];
let _e2442 = (_e2428 + ((bitcast<f32>(_e2437) - _e2428) * _e2439));
let _e2443 = (_e2346 + _e2344);
let _e2444 = local.member[1u];
let _e2445 = (_e2443 + _e2444);
let _e2447 = select(_e2363, _e2445, (_e2445 < _e2363));
let _e2452 = global_2.member[bitcast<u32>(select(0i, _e2447, (_e2447 > 0i)))];
let _e2453 = bitcast<f32>(_e2452);
let _e2454 = local.member[2u];
let _e2455 = (_e2443 + _e2454);
let _e2457 = select(_e2363, _e2455, (_e2455 < _e2363));
let _e2462 = global_2.member[bitcast<u32>(select(0i, _e2457, (_e2457 > 0i)))];
let _e2464 = local_1[0u];
let _e2468 = local_1[1u];
let _e2473 = local_1[2u];
let _e2481 = global_1.member.member_5.member_4.member;
let _e2487 = global_1.member.member_5.member_4.member_1;
let _e2488 = (((_e2417 + (((_e2442 + (((_e2453 + ((bitcast<f32>(_e2462) - _e2453) * _e2464)) - _e2442) * _e2468)) - _e2417) * _e2473)) * _e2481) + _e2487);
let _e2490 = select(0f, _e2488, (_e2488 > 0f));
let _e2492 = select(1f, _e2490, (_e2490 < 1f));
let _e2496 = global_1.member.member[3u];
if ((_e2496 & 16u) == 0u) {
phi_8132_ = type_21(1f, 1f, 1f);
} else {
let _e2501 = global_1.member.member_18;
let _e2505 = global_1.member.member_22.member;
let _e2515 = ((((_e2501.member * _e636) + (_e2501.member_1 * _e649)) + (_e2501.member_2 * _e614)) + _e2501.member_3);
let _e2521 = ((((_e2501.member * _e659) + (_e2501.member_1 * _e664)) + (_e2501.member_2 * _e653)) + _e2501.member_3);
let _e2523 = select(_e2521, _e2515, (_e2515 < _e2521));
let _e2525 = select(_e2521, _e2515, (_e2515 > _e2521));
let _e2527 = (_e2525 - _e2523);
let _e2530 = (-(_e2523) / select(1e-30f, _e2527, (_e2527 > 1e-30f)));
let _e2532 = select(0f, _e2530, (_e2530 > 0f));
let _e2538 = select(select(select(1f, _e2532, (_e2532 < 1f)), 1f, (_e2525 <= 0f)), 0f, (_e2523 > 0f));
let _e2540 = (_e2505 > 0.5f);
let _e2549 = global_1.member.member_19;
let _e2553 = global_1.member.member_22.member_1;
let _e2563 = ((((_e2549.member * _e636) + (_e2549.member_1 * _e649)) + (_e2549.member_2 * _e614)) + _e2549.member_3);
let _e2569 = ((((_e2549.member * _e659) + (_e2549.member_1 * _e664)) + (_e2549.member_2 * _e653)) + _e2549.member_3);
let _e2571 = select(_e2569, _e2563, (_e2563 < _e2569));
let _e2573 = select(_e2569, _e2563, (_e2563 > _e2569));
let _e2575 = (_e2573 - _e2571);
let _e2578 = (-(_e2571) / select(1e-30f, _e2575, (_e2575 > 1e-30f)));
let _e2580 = select(0f, _e2578, (_e2578 > 0f));
let _e2586 = select(select(select(1f, _e2580, (_e2580 < 1f)), 1f, (_e2573 <= 0f)), 0f, (_e2571 > 0f));
let _e2588 = (_e2553 > 0.5f);
let _e2597 = global_1.member.member_20;
let _e2601 = global_1.member.member_22.member_2;
let _e2611 = ((((_e2597.member * _e636) + (_e2597.member_1 * _e649)) + (_e2597.member_2 * _e614)) + _e2597.member_3);
let _e2617 = ((((_e2597.member * _e659) + (_e2597.member_1 * _e664)) + (_e2597.member_2 * _e653)) + _e2597.member_3);
let _e2619 = select(_e2617, _e2611, (_e2611 < _e2617));
let _e2621 = select(_e2617, _e2611, (_e2611 > _e2617));
let _e2623 = (_e2621 - _e2619);
let _e2626 = (-(_e2619) / select(1e-30f, _e2623, (_e2623 > 1e-30f)));
let _e2628 = select(0f, _e2626, (_e2626 > 0f));
let _e2634 = select(select(select(1f, _e2628, (_e2628 < 1f)), 1f, (_e2621 <= 0f)), 0f, (_e2619 > 0f));
let _e2636 = (_e2601 > 0.5f);
let _e2645 = global_1.member.member_21;
let _e2649 = global_1.member.member_22.member_3;
let _e2659 = ((((_e2645.member * _e636) + (_e2645.member_1 * _e649)) + (_e2645.member_2 * _e614)) + _e2645.member_3);
let _e2665 = ((((_e2645.member * _e659) + (_e2645.member_1 * _e664)) + (_e2645.member_2 * _e653)) + _e2645.member_3);
let _e2667 = select(_e2665, _e2659, (_e2659 < _e2665));
let _e2669 = select(_e2665, _e2659, (_e2659 > _e2665));
let _e2671 = (_e2669 - _e2667);
let _e2674 = (-(_e2667) / select(1e-30f, _e2671, (_e2671 > 1e-30f)));
let _e2676 = select(0f, _e2674, (_e2674 > 0f));
let _e2682 = select(select(select(1f, _e2676, (_e2676 < 1f)), 1f, (_e2669 <= 0f)), 0f, (_e2667 > 0f));
let _e2684 = (_e2649 > 0.5f);
phi_8132_ = type_21(((((1f * _e2538) * _e2586) * _e2634) * _e2682), ((((1f * select(1f, _e2538, _e2540)) * select(1f, _e2586, _e2588)) * select(1f, _e2634, _e2636)) * select(1f, _e2682, _e2684)), ((((1f * select(1f, 0f, (_e2540 && (_e2521 > 0f)))) * select(1f, 0f, (_e2588 && (_e2569 > 0f)))) * select(1f, 0f, (_e2636 && (_e2617 > 0f)))) * select(1f, 0f, (_e2684 && (_e2665 > 0f)))));
}
let _e2693 = phi_8132_;
let _e2694 = (_e724 - _e682);
let _e2698 = (bitcast<f32>((bitcast<u32>(_e2694) & 2147483647u)) < 1e-12f);
let _e2700 = (1f / select(_e2694, 1f, _e2698));
let _e2702 = ((-0.5f - _e682) * _e2700);
let _e2704 = ((_e2218 - _e682) * _e2700);
let _e2710 = select(_e2704, _e2702, (_e2702 < _e2704));
let _e2712 = select(0f, _e2710, (_e2710 > 0f));
let _e2715 = select(select(1f, _e2712, (_e2712 < 1f)), select(2f, 0f, ((_e682 >= -0.5f) && (_e682 <= _e2218))), _e2698);
let _e2717 = select(_e2704, _e2702, (_e2702 > _e2704));
let _e2719 = select(0f, _e2717, (_e2717 > 0f));
let _e2722 = select(select(1f, _e2719, (_e2719 < 1f)), 1f, _e2698);
let _e2723 = (_e730 - _e700);
let _e2727 = (bitcast<f32>((bitcast<u32>(_e2723) & 2147483647u)) < 1e-12f);
let _e2729 = (1f / select(_e2723, 1f, _e2727));
let _e2731 = ((-0.5f - _e700) * _e2729);
let _e2733 = ((_e2228 - _e700) * _e2729);
let _e2739 = select(_e2733, _e2731, (_e2731 < _e2733));
let _e2741 = select(0f, _e2739, (_e2739 > 0f));
let _e2744 = select(select(1f, _e2741, (_e2741 < 1f)), select(2f, 0f, ((_e700 >= -0.5f) && (_e700 <= _e2228))), _e2727);
let _e2746 = select(_e2733, _e2731, (_e2731 > _e2733));
let _e2748 = select(0f, _e2746, (_e2746 > 0f));
let _e2751 = select(select(1f, _e2748, (_e2748 < 1f)), 1f, _e2727);
let _e2752 = (_e736 - _e718);
let _e2756 = (bitcast<f32>((bitcast<u32>(_e2752) & 2147483647u)) < 1e-12f);
let _e2758 = (1f / select(_e2752, 1f, _e2756));
let _e2760 = ((-0.5f - _e718) * _e2758);
let _e2762 = ((_e2238 - _e718) * _e2758);
let _e2768 = select(_e2762, _e2760, (_e2760 < _e2762));
let _e2770 = select(0f, _e2768, (_e2768 > 0f));
let _e2773 = select(select(1f, _e2770, (_e2770 < 1f)), select(2f, 0f, ((_e718 >= -0.5f) && (_e718 <= _e2238))), _e2756);
let _e2775 = select(_e2762, _e2760, (_e2760 > _e2762));
let _e2777 = select(0f, _e2775, (_e2775 > 0f));
let _e2780 = select(select(1f, _e2777, (_e2777 < 1f)), 1f, _e2756);
let _e2782 = select(_e2751, _e2722, (_e2722 < _e2751));
let _e2786 = select(_e2744, _e2715, (_e2715 > _e2744));
let _e2789 = (select(_e2780, _e2782, (_e2782 < _e2780)) - select(_e2773, _e2786, (_e2786 > _e2773)));
let _e2792 = (_e659 - _e636);
let _e2793 = (_e664 - _e649);
let _e2794 = (_e653 - _e614);
let _e2799 = (((_e2792 * _e2792) + (_e2793 * _e2793)) + (_e2794 * _e2794));
let _e2807 = global_1.member.member_4.member_3;
let _e2808 = ((sqrt(select(0f, _e2799, (_e2799 > 0f))) * select(0f, _e2789, (_e2789 > 0f))) * _e2807);
if (_e581 >= 3u) {
let _e3261 = (_e2492 * 255f);
let _e3262 = (_e2212.member * 255f);
let _e3263 = (255f - 1f);
let _e3265 = select(0f, _e3261, (_e3261 > 0f));
let _e3267 = select(_e3263, _e3265, (_e3265 < _e3263));
let _e3274 = select(0i, select(select(i32(_e3267), i32(-2147483648), (_e3267 < -2147483600f)), 2147483647i, (_e3267 > 2147483500f)), (_e3267 == _e3267));
let _e3278 = (_e3274 - select(0i, 1i, (_e3267 < f32(_e3274))));
let _e3280 = select(0f, _e3262, (_e3262 > 0f));
let _e3282 = select(_e3263, _e3280, (_e3280 < _e3263));
let _e3289 = select(0i, select(select(i32(_e3282), i32(-2147483648), (_e3282 < -2147483600f)), 2147483647i, (_e3282 > 2147483500f)), (_e3282 == _e3282));
let _e3293 = (_e3289 - select(0i, 1i, (_e3282 < f32(_e3289))));
let _e3296 = (((_e3278 * 256i) + _e3293) * 4i);
let _e3300 = (_e3262 - f32(_e3293));
let _e3302 = (bitcast<i32>(_e90) - 1i);
let _e3304 = select(_e3302, _e3296, (_e3296 < _e3302));
let _e3310 = global_4.member[bitcast<u32>(select(0i, _e3304, (_e3304 > 0i)))];
let _e3311 = (_e3296 + 4i);
let _e3313 = select(_e3302, _e3311, (_e3311 < _e3302));
let _e3319 = global_4.member[bitcast<u32>(select(0i, _e3313, (_e3313 > 0i)))];
let _e3320 = (_e3296 + 1024i);
let _e3322 = select(_e3302, _e3320, (_e3320 < _e3302));
let _e3328 = global_4.member[bitcast<u32>(select(0i, _e3322, (_e3322 > 0i)))];
let _e3329 = (_e3296 + 1028i);
let _e3331 = select(_e3302, _e3329, (_e3329 < _e3302));
let _e3337 = global_4.member[bitcast<u32>(select(0i, _e3331, (_e3331 > 0i)))];
let _e3342 = (bitcast<f32>(((_e3310 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3350 = (_e3342 + (((bitcast<f32>(((_e3319 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3342) * _e3300));
let _e3355 = (bitcast<f32>(((_e3328 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3366 = (_e3350 + (((_e3355 + (((bitcast<f32>(((_e3337 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3355) * _e3300)) - _e3350) * (_e3261 - f32(_e3278))));
let _e3370 = -((_e3366 * (_e2808 * _e2693.member)));
let _e3372 = select(-87f, _e3370, (_e3370 > -87f));
let _e3374 = select(88f, _e3372, (_e3372 < 88f));
let _e3376 = ((_e3374 * 1.442695f) + 0.5f);
let _e3378 = select(-127f, _e3376, (_e3376 > -127f));
let _e3380 = select(128f, _e3378, (_e3378 < 128f));
let _e3387 = select(0i, select(select(i32(_e3380), i32(-2147483648), (_e3380 < -2147483600f)), 2147483647i, (_e3380 > 2147483500f)), (_e3380 == _e3380));
let _e3391 = (_e3387 - select(0i, 1i, (_e3380 < f32(_e3387))));
let _e3392 = f32(_e3391);
let _e3396 = ((_e3374 - (_e3392 * 0.6933594f)) - (_e3392 * -2.1219444e-4f));
let _e3416 = ((1f + (_e3396 * (1f + (_e3396 * (0.5f + (_e3396 * (0.16666667f + (_e3396 * (0.041666668f + (_e3396 * (0.008333334f + (_e3396 * (0.001388889f + (_e3396 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3391 + 127i)) << bitcast<u32>(23i))));
let _e3417 = (1f - _e3416);
phi_9242_ = type_22(_e3416, _e3417, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e3417 / select(1e-12f, _e3366, (_e3366 > 1e-12f))))));
} else {
let _e2811 = (_e2492 * 255f);
let _e2812 = (_e2212.member * 255f);
let _e2813 = (255f - 1f);
let _e2815 = select(0f, _e2811, (_e2811 > 0f));
let _e2817 = select(_e2813, _e2815, (_e2815 < _e2813));
let _e2824 = select(0i, select(select(i32(_e2817), i32(-2147483648), (_e2817 < -2147483600f)), 2147483647i, (_e2817 > 2147483500f)), (_e2817 == _e2817));
let _e2828 = (_e2824 - select(0i, 1i, (_e2817 < f32(_e2824))));
let _e2830 = select(0f, _e2812, (_e2812 > 0f));
let _e2832 = select(_e2813, _e2830, (_e2830 < _e2813));
let _e2839 = select(0i, select(select(i32(_e2832), i32(-2147483648), (_e2832 < -2147483600f)), 2147483647i, (_e2832 > 2147483500f)), (_e2832 == _e2832));
let _e2843 = (_e2839 - select(0i, 1i, (_e2832 < f32(_e2839))));
let _e2846 = (((_e2828 * 256i) + _e2843) * 4i);
let _e2848 = (_e2811 - f32(_e2828));
let _e2850 = (_e2812 - f32(_e2843));
let _e2852 = (bitcast<i32>(_e90) - 1i);
let _e2854 = select(_e2852, _e2846, (_e2846 < _e2852));
let _e2860 = global_4.member[bitcast<u32>(select(0i, _e2854, (_e2854 > 0i)))];
let _e2861 = (_e2846 + 4i);
let _e2863 = select(_e2852, _e2861, (_e2861 < _e2852));
let _e2869 = global_4.member[bitcast<u32>(select(0i, _e2863, (_e2863 > 0i)))];
let _e2870 = (_e2846 + 1024i);
let _e2872 = select(_e2852, _e2870, (_e2870 < _e2852));
let _e2878 = global_4.member[bitcast<u32>(select(0i, _e2872, (_e2872 > 0i)))];
let _e2879 = (_e2846 + 1028i);
let _e2881 = select(_e2852, _e2879, (_e2879 < _e2852));
let _e2887 = global_4.member[bitcast<u32>(select(0i, _e2881, (_e2881 > 0i)))];
let _e2892 = (bitcast<f32>(((_e2860 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2900 = (_e2892 + (((bitcast<f32>(((_e2869 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2892) * _e2850));
let _e2905 = (bitcast<f32>(((_e2878 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2916 = (_e2900 + (((_e2905 + (((bitcast<f32>(((_e2887 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2905) * _e2850)) - _e2900) * _e2848));
let _e2929 = (bitcast<f32>((((_e2860 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2937 = (_e2929 + (((bitcast<f32>((((_e2869 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2929) * _e2850));
let _e2942 = (bitcast<f32>((((_e2878 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2954 = (_e2846 + 1i);
let _e2956 = select(_e2852, _e2954, (_e2954 < _e2852));
let _e2962 = global_4.member[bitcast<u32>(select(0i, _e2956, (_e2956 > 0i)))];
let _e2963 = (_e2846 + 5i);
let _e2965 = select(_e2852, _e2963, (_e2963 < _e2852));
let _e2971 = global_4.member[bitcast<u32>(select(0i, _e2965, (_e2965 > 0i)))];
let _e2972 = (_e2846 + 1025i);
let _e2974 = select(_e2852, _e2972, (_e2972 < _e2852));
let _e2980 = global_4.member[bitcast<u32>(select(0i, _e2974, (_e2974 > 0i)))];
let _e2981 = (_e2846 + 1029i);
let _e2983 = select(_e2852, _e2981, (_e2981 < _e2852));
let _e2989 = global_4.member[bitcast<u32>(select(0i, _e2983, (_e2983 > 0i)))];
let _e2994 = (bitcast<f32>(((_e2962 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3002 = (_e2994 + (((bitcast<f32>(((_e2971 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2994) * _e2850));
let _e3007 = (bitcast<f32>(((_e2980 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3031 = (bitcast<f32>((((_e2962 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3039 = (_e3031 + (((bitcast<f32>((((_e2971 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3031) * _e2850));
let _e3044 = (bitcast<f32>((((_e2980 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3059 = (_e2808 * _e2693.member_1);
let _e3061 = -(((_e2937 + (((_e2942 + (((bitcast<f32>((((_e2887 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2942) * _e2850)) - _e2937) * _e2848)) * _e3059));
let _e3063 = select(-87f, _e3061, (_e3061 > -87f));
let _e3065 = select(88f, _e3063, (_e3063 < 88f));
let _e3067 = ((_e3065 * 1.442695f) + 0.5f);
let _e3069 = select(-127f, _e3067, (_e3067 > -127f));
let _e3071 = select(128f, _e3069, (_e3069 < 128f));
let _e3078 = select(0i, select(select(i32(_e3071), i32(-2147483648), (_e3071 < -2147483600f)), 2147483647i, (_e3071 > 2147483500f)), (_e3071 == _e3071));
let _e3082 = (_e3078 - select(0i, 1i, (_e3071 < f32(_e3078))));
let _e3083 = f32(_e3082);
let _e3087 = ((_e3065 - (_e3083 * 0.6933594f)) - (_e3083 * -2.1219444e-4f));
let _e3109 = -(((_e3002 + (((_e3007 + (((bitcast<f32>(((_e2989 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3007) * _e2850)) - _e3002) * _e2848)) * _e3059));
let _e3111 = select(-87f, _e3109, (_e3109 > -87f));
let _e3113 = select(88f, _e3111, (_e3111 < 88f));
let _e3115 = ((_e3113 * 1.442695f) + 0.5f);
let _e3117 = select(-127f, _e3115, (_e3115 > -127f));
let _e3119 = select(128f, _e3117, (_e3117 < 128f));
let _e3126 = select(0i, select(select(i32(_e3119), i32(-2147483648), (_e3119 < -2147483600f)), 2147483647i, (_e3119 > 2147483500f)), (_e3119 == _e3119));
let _e3130 = (_e3126 - select(0i, 1i, (_e3119 < f32(_e3126))));
let _e3131 = f32(_e3130);
let _e3135 = ((_e3113 - (_e3131 * 0.6933594f)) - (_e3131 * -2.1219444e-4f));
let _e3157 = -(((_e3039 + (((_e3044 + (((bitcast<f32>((((_e2989 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3044) * _e2850)) - _e3039) * _e2848)) * _e3059));
let _e3159 = select(-87f, _e3157, (_e3157 > -87f));
let _e3161 = select(88f, _e3159, (_e3159 < 88f));
let _e3163 = ((_e3161 * 1.442695f) + 0.5f);
let _e3165 = select(-127f, _e3163, (_e3163 > -127f));
let _e3167 = select(128f, _e3165, (_e3165 < 128f));
let _e3174 = select(0i, select(select(i32(_e3167), i32(-2147483648), (_e3167 < -2147483600f)), 2147483647i, (_e3167 > 2147483500f)), (_e3167 == _e3167));
let _e3178 = (_e3174 - select(0i, 1i, (_e3167 < f32(_e3174))));
let _e3179 = f32(_e3178);
let _e3183 = ((_e3161 - (_e3179 * 0.6933594f)) - (_e3179 * -2.1219444e-4f));
let _e3206 = -((_e2916 * (_e2808 * _e2693.member)));
let _e3208 = select(-87f, _e3206, (_e3206 > -87f));
let _e3210 = select(88f, _e3208, (_e3208 < 88f));
let _e3212 = ((_e3210 * 1.442695f) + 0.5f);
let _e3214 = select(-127f, _e3212, (_e3212 > -127f));
let _e3216 = select(128f, _e3214, (_e3214 < 128f));
let _e3223 = select(0i, select(select(i32(_e3216), i32(-2147483648), (_e3216 < -2147483600f)), 2147483647i, (_e3216 > 2147483500f)), (_e3216 == _e3216));
let _e3227 = (_e3223 - select(0i, 1i, (_e3216 < f32(_e3223))));
let _e3228 = f32(_e3227);
let _e3232 = ((_e3210 - (_e3228 * 0.6933594f)) - (_e3228 * -2.1219444e-4f));
let _e3252 = ((1f + (_e3232 * (1f + (_e3232 * (0.5f + (_e3232 * (0.16666667f + (_e3232 * (0.041666668f + (_e3232 * (0.008333334f + (_e3232 * (0.001388889f + (_e3232 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3227 + 127i)) << bitcast<u32>(23i))));
let _e3253 = (1f - _e3252);
phi_9242_ = type_22(_e3252, _e3253, vec3<f32>(((1f + (_e3087 * (1f + (_e3087 * (0.5f + (_e3087 * (0.16666667f + (_e3087 * (0.041666668f + (_e3087 * (0.008333334f + (_e3087 * (0.001388889f + (_e3087 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3082 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3135 * (1f + (_e3135 * (0.5f + (_e3135 * (0.16666667f + (_e3135 * (0.041666668f + (_e3135 * (0.008333334f + (_e3135 * (0.001388889f + (_e3135 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3130 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3183 * (1f + (_e3183 * (0.5f + (_e3183 * (0.16666667f + (_e3183 * (0.041666668f + (_e3183 * (0.008333334f + (_e3183 * (0.001388889f + (_e3183 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3178 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e3253 / select(1e-12f, _e2916, (_e2916 > 1e-12f))))));
}
let _e3425 = phi_9242_;
if _e741 {
let _e3429 = global_1.member.member_4.member_2;
let _e3437 = global_1.member.member_24.member_2;
let _e3440 = (_e2212.member_3.x * _e2693.member_2);
let _e3442 = (_e2212.member_3.y * _e2693.member_2);
let _e3444 = (_e2212.member_3.z * _e2693.member_2);
let _e3445 = (0.5f * (_e3429 / select(1e-6f, _e183, (_e183 > 1e-6f))));
let _e3449 = (_e161 + (_e3440 * _e3445));
let _e3450 = (_e172 + (_e3442 * _e3445));
let _e3451 = (_e183 + (_e3444 * _e3445));
let _e3453 = (2f * _e3429);
let _e3455 = ((_e3451 * _e3451) + (_e3453 * _e3444));
let _e3459 = (_e3451 + sqrt(select(0f, _e3455, (_e3455 > 0f))));
let _e3463 = (0.5f * (_e3453 / select(1e-6f, _e3459, (_e3459 > 1e-6f))));
let _e3467 = (_e3449 + (_e3440 * _e3463));
let _e3468 = (_e3450 + (_e3442 * _e3463));
let _e3469 = (_e3451 + (_e3444 * _e3463));
let _e3473 = (_e3437 * _e3437);
let _e3475 = (_e3469 * _e3469);
let _e3483 = (((_e3451 <= 0f) || (_e3455 <= 0f)) || ((_e3469 <= 0f) || (_e3475 <= (_e3473 * (((_e3467 * _e3467) + (_e3468 * _e3468)) + _e3475)))));
let _e3497 = (_e161 + ((_e2212.member_4.x * _e2693.member_2) * _e3429));
let _e3498 = (_e172 + ((_e2212.member_4.y * _e2693.member_2) * _e3429));
let _e3499 = (_e183 + ((_e2212.member_4.z * _e2693.member_2) * _e3429));
let _e3501 = (_e3499 * _e3499);
let _e3510 = ((_e2496 & 1u) != 0u);
let _e3514 = select(_e3483, ((_e3499 <= 0f) || (_e3501 <= (_e3473 * (((_e3497 * _e3497) + (_e3498 * _e3498)) + _e3501)))), _e3510);
phi_9393_ = select(select(select(_e3469, _e3451, _e3483), _e3499, _e3510), _e183, _e3514);
phi_9394_ = select(select(select(_e3468, _e3450, _e3483), _e3498, _e3510), _e172, _e3514);
phi_9395_ = select(select(select(_e3467, _e3449, _e3483), _e3497, _e3510), _e161, _e3514);
phi_9396_ = select(1f, 0f, _e3514);
} else {
phi_9393_ = _e183;
phi_9394_ = _e172;
phi_9395_ = _e161;
phi_9396_ = 1f;
}
let _e3520 = phi_9393_;
let _e3522 = phi_9394_;
let _e3524 = phi_9395_;
let _e3526 = phi_9396_;
let _e3529 = (_e3425.member * _e3526);
global_5.member[_e118] = (_e129 * (_e3425.member_2.x * _e3529));
global_5.member[_e130] = (_e139 * (_e3425.member_2.y * _e3529));
global_5.member[_e141] = (_e150 * (_e3425.member_2.z * _e3529));
global_5.member[_e152] = _e3524;
global_5.member[_e163] = _e3522;
global_5.member[_e174] = _e3520;
global_5.member[_e185] = _e194;
global_5.member[_e196] = _e205;
global_5.member[_e207] = _e216;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
