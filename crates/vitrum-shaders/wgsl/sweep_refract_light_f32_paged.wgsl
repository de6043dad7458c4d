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
let _e85 = global;
let _e88 = arrayLength((&global_2.member));
let _e92 = arrayLength((&global_4.member));
let _e94 = arrayLength((&global_6.member));
let _e99 = global_1.member.member_1;
let _e102 = (_e85.x + _e99.x);
let _e105 = (_e85.y + _e99.y);
if (_e102 < _e99.z) {
if (_e105 < _e99.w) {
let _e113 = global_1.member.member[0u];
let _e117 = global_1.member.member[1u];
let _e118 = (_e113 * _e117);
let _e120 = ((_e105 * _e113) + _e102);
let _e121 = bitcast<i32>(_e120);
let _e123 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e125 = select(_e123, _e121, (_e121 < _e123));
let _e131 = global_5.member[bitcast<u32>(select(0i, _e125, (_e125 > 0i)))];
let _e132 = (_e118 + _e120);
let _e133 = bitcast<i32>(_e132);
let _e135 = select(_e123, _e133, (_e133 < _e123));
let _e141 = global_5.member[bitcast<u32>(select(0i, _e135, (_e135 > 0i)))];
let _e143 = ((2u * _e118) + _e120);
let _e144 = bitcast<i32>(_e143);
let _e146 = select(_e123, _e144, (_e144 < _e123));
let _e152 = global_5.member[bitcast<u32>(select(0i, _e146, (_e146 > 0i)))];
let _e154 = ((3u * _e118) + _e120);
let _e155 = bitcast<i32>(_e154);
let _e157 = select(_e123, _e155, (_e155 < _e123));
let _e163 = global_5.member[bitcast<u32>(select(0i, _e157, (_e157 > 0i)))];
let _e165 = ((4u * _e118) + _e120);
let _e166 = bitcast<i32>(_e165);
let _e168 = select(_e123, _e166, (_e166 < _e123));
let _e174 = global_5.member[bitcast<u32>(select(0i, _e168, (_e168 > 0i)))];
let _e176 = ((5u * _e118) + _e120);
let _e177 = bitcast<i32>(_e176);
let _e179 = select(_e123, _e177, (_e177 < _e123));
let _e185 = global_5.member[bitcast<u32>(select(0i, _e179, (_e179 > 0i)))];
let _e187 = ((6u * _e118) + _e120);
let _e188 = bitcast<i32>(_e187);
let _e190 = select(_e123, _e188, (_e188 < _e123));
let _e196 = global_5.member[bitcast<u32>(select(0i, _e190, (_e190 > 0i)))];
let _e198 = ((7u * _e118) + _e120);
let _e199 = bitcast<i32>(_e198);
let _e201 = select(_e123, _e199, (_e199 < _e123));
let _e207 = global_5.member[bitcast<u32>(select(0i, _e201, (_e201 > 0i)))];
let _e209 = ((8u * _e118) + _e120);
let _e210 = bitcast<i32>(_e209);
let _e212 = select(_e123, _e210, (_e210 < _e123));
let _e218 = global_5.member[bitcast<u32>(select(0i, _e212, (_e212 > 0i)))];
let _e222 = global_1.member.member_2[2u];
let _e226 = global_1.member.member_2[3u];
let _e227 = (_e222 * _e226);
if (_e94 >= (_e227 * 2u)) {
let _e231 = bitcast<i32>((_e105 * _e222));
let _e233 = bitcast<i32>(_e102);
let _e238 = global_6.member[bitcast<u32>((_e231 + _e233))];
let _e244 = global_6.member[bitcast<u32>(((bitcast<i32>(_e227) + _e231) + _e233))];
let _e245 = f32(_e233);
let _e247 = f32(bitcast<i32>(_e105));
let _e253 = global_1.member.member_4.member;
let _e257 = global_1.member.member_8.member_2;
let _e258 = (_e253 - _e257);
let _e262 = global_1.member.member_7.member;
let _e266 = global_1.member.member_8.member;
let _e273 = global_1.member.member_7.member_2;
let _e275 = ((_e262 + (_e266 * _e258)) + (((_e245 - _e238) + 0.5f) * _e273));
let _e279 = global_1.member.member_7.member_1;
let _e283 = global_1.member.member_8.member_1;
let _e288 = ((_e279 + (_e283 * _e258)) + (((_e247 - _e244) + 0.5f) * _e273));
let _e292 = global_1.member.member_4.member_1;
let _e293 = (_e292 - _e257);
let _e298 = ((_e262 + (_e266 * _e293)) + ((_e245 + 0.5f) * _e273));
let _e303 = ((_e279 + (_e283 * _e293)) + ((_e247 + 0.5f) * _e273));
let _e307 = global_1.member.member_5.member;
let _e320 = global_1.member.member_5.member.member_3;
let _e321 = ((((_e307.member * _e275) + (_e307.member_1 * _e288)) + (_e307.member_2 * _e253)) + _e320);
let _e325 = global_1.member.member_5.member_1;
let _e338 = global_1.member.member_5.member_1.member_3;
let _e339 = ((((_e325.member * _e275) + (_e325.member_1 * _e288)) + (_e325.member_2 * _e253)) + _e338);
let _e343 = global_1.member.member_5.member_2;
let _e356 = global_1.member.member_5.member_2.member_3;
let _e357 = ((((_e343.member * _e275) + (_e343.member_1 * _e288)) + (_e343.member_2 * _e253)) + _e356);
let _e363 = ((((_e307.member * _e298) + (_e307.member_1 * _e303)) + (_e307.member_2 * _e292)) + _e320);
let _e369 = ((((_e325.member * _e298) + (_e325.member_1 * _e303)) + (_e325.member_2 * _e292)) + _e338);
let _e375 = ((((_e343.member * _e298) + (_e343.member_1 * _e303)) + (_e343.member_2 * _e292)) + _e356);
let _e381 = global_1.member.member_5.member_3.member;
let _e382 = (_e381 - 1f);
let _e391 = global_1.member.member_5.member_3.member_1;
let _e392 = (_e391 - 1f);
let _e401 = global_1.member.member_5.member_3.member_2;
let _e402 = (_e401 - 1f);
let _e422 = global_1.member.member_5.member_3.member_3;
let _e423 = (_e381 - 0.5f);
let _e425 = select(-0.5f, _e363, (_e363 > -0.5f));
let _e427 = select(_e423, _e425, (_e425 < _e423));
let _e428 = (_e391 - 0.5f);
let _e430 = select(-0.5f, _e369, (_e369 > -0.5f));
let _e432 = select(_e428, _e430, (_e430 < _e428));
let _e433 = (_e401 - 0.5f);
let _e435 = select(-0.5f, _e375, (_e375 > -0.5f));
let _e437 = select(_e433, _e435, (_e435 < _e433));
let _e443 = bitcast<f32>((bitcast<u32>((_e363 - _e321)) & 2147483647u));
let _e446 = bitcast<f32>((bitcast<u32>((_e369 - _e339)) & 2147483647u));
let _e448 = select(_e446, _e443, (_e443 > _e446));
let _e451 = bitcast<f32>((bitcast<u32>((_e375 - _e357)) & 2147483647u));
let _e460 = bitcast<f32>((bitcast<u32>((_e363 - _e427)) & 2147483647u));
let _e463 = bitcast<f32>((bitcast<u32>((_e369 - _e432)) & 2147483647u));
let _e465 = select(_e463, _e460, (_e460 > _e463));
let _e468 = bitcast<f32>((bitcast<u32>((_e375 - _e437)) & 2147483647u));
let _e472 = (_e427 + 0.5f);
let _e474 = select(0f, _e472, (_e472 > 0f));
let _e476 = select(_e382, _e474, (_e474 < _e382));
let _e483 = select(0i, select(select(i32(_e476), i32(-2147483648), (_e476 < -2147483600f)), 2147483647i, (_e476 > 2147483500f)), (_e476 == _e476));
let _e492 = global_1.member.member_5.member_7[3u];
let _e493 = (_e492 & 31i);
let _e496 = (_e432 + 0.5f);
let _e498 = select(0f, _e496, (_e496 > 0f));
let _e500 = select(_e392, _e498, (_e498 < _e392));
let _e507 = select(0i, select(select(i32(_e500), i32(-2147483648), (_e500 < -2147483600f)), 2147483647i, (_e500 > 2147483500f)), (_e500 == _e500));
let _e514 = (_e437 + 0.5f);
let _e516 = select(0f, _e514, (_e514 > 0f));
let _e518 = select(_e402, _e516, (_e516 < _e402));
let _e525 = select(0i, select(select(i32(_e518), i32(-2147483648), (_e518 < -2147483600f)), 2147483647i, (_e518 > 2147483500f)), (_e518 == _e518));
let _e536 = global_1.member.member_5.member_6[3u];
let _e542 = global_1.member.member_5.member_6[0u];
let _e547 = global_1.member.member_5.member_6[1u];
let _e551 = ((_e536 + ((_e483 - select(0i, 1i, (_e476 < f32(_e483)))) >> bitcast<u32>(_e493))) + (_e542 * (((_e507 - select(0i, 1i, (_e500 < f32(_e507)))) >> bitcast<u32>(_e493)) + (_e547 * ((_e525 - select(0i, 1i, (_e518 < f32(_e525)))) >> bitcast<u32>(_e493))))));
let _e553 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e555 = select(_e553, _e551, (_e551 < _e553));
let _e561 = global_3.member[bitcast<u32>(select(0i, _e555, (_e555 > 0i)))];
let _e568 = global_1.member.member[3u];
phi_944_ = select(select(7u, 3u, (((((((_e321 >= 0f) && (_e321 <= _e382)) && (_e339 >= 0f)) && (_e339 <= _e392)) && (_e357 >= 0f)) && (_e357 <= _e402)) && ((((((_e363 >= 0f) && (_e363 <= _e382)) && (_e369 >= 0f)) && (_e369 <= _e392)) && (_e375 >= 0f)) && (_e375 <= _e402)))), 1u, (((_e568 & 64u) != 0u) || ((((select(_e451, _e448, (_e448 > _e451)) <= _e422) && ((select(_e468, _e465, (_e465 > _e468)) > _e422) || (_e561 != 0u))) && true) && ((_e568 & 32u) != 0u))));
} else {
phi_944_ = 7u;
}
let _e578 = phi_944_;
if (_e578 > 1u) {
let _e583 = global_1.member.member[2u];
let _e586 = bitcast<i32>(((_e105 * _e222) + _e102));
let _e589 = (bitcast<i32>(_e94) - 1i);
let _e591 = select(_e589, _e586, (_e586 < _e589));
let _e597 = global_6.member[bitcast<u32>(select(0i, _e591, (_e591 > 0i)))];
let _e598 = (bitcast<i32>(_e227) + _e586);
let _e600 = select(_e589, _e598, (_e598 < _e589));
let _e606 = global_6.member[bitcast<u32>(select(0i, _e600, (_e600 > 0i)))];
let _e608 = f32(bitcast<i32>(_e102));
let _e610 = f32(bitcast<i32>(_e105));
let _e616 = global_1.member.member_4.member;
let _e620 = global_1.member.member_8.member_2;
let _e621 = (_e616 - _e620);
let _e625 = global_1.member.member_7.member;
let _e629 = global_1.member.member_8.member;
let _e636 = global_1.member.member_7.member_2;
let _e638 = ((_e625 + (_e629 * _e621)) + (((_e608 - _e597) + 0.5f) * _e636));
let _e642 = global_1.member.member_7.member_1;
let _e646 = global_1.member.member_8.member_1;
let _e651 = ((_e642 + (_e646 * _e621)) + (((_e610 - _e606) + 0.5f) * _e636));
let _e655 = global_1.member.member_4.member_1;
let _e656 = (_e655 - _e620);
let _e661 = ((_e625 + (_e629 * _e656)) + ((_e608 + 0.5f) * _e636));
let _e666 = ((_e642 + (_e646 * _e656)) + ((_e610 + 0.5f) * _e636));
let _e670 = global_1.member.member_5.member;
let _e683 = global_1.member.member_5.member.member_3;
let _e684 = ((((_e670.member * _e638) + (_e670.member_1 * _e651)) + (_e670.member_2 * _e616)) + _e683);
let _e688 = global_1.member.member_5.member_1;
let _e701 = global_1.member.member_5.member_1.member_3;
let _e702 = ((((_e688.member * _e638) + (_e688.member_1 * _e651)) + (_e688.member_2 * _e616)) + _e701);
let _e706 = global_1.member.member_5.member_2;
let _e719 = global_1.member.member_5.member_2.member_3;
let _e720 = ((((_e706.member * _e638) + (_e706.member_1 * _e651)) + (_e706.member_2 * _e616)) + _e719);
let _e726 = ((((_e670.member * _e661) + (_e670.member_1 * _e666)) + (_e670.member_2 * _e655)) + _e683);
let _e732 = ((((_e688.member * _e661) + (_e688.member_1 * _e666)) + (_e688.member_2 * _e655)) + _e701);
let _e738 = ((((_e706.member * _e661) + (_e706.member_1 * _e666)) + (_e706.member_2 * _e655)) + _e719);
let _e740 = (_e583 == 2u);
let _e743 = (((_e583 == 1u) || _e740) || (_e583 == 5u));
if _e743 {
let _e1027 = global_1.member.member_5.member_3.member;
let _e1028 = (_e1027 - 0.5f);
let _e1030 = select(-0.5f, _e726, (_e726 > -0.5f));
let _e1032 = select(_e1028, _e1030, (_e1030 < _e1028));
let _e1037 = global_1.member.member_5.member_3.member_1;
let _e1038 = (_e1037 - 0.5f);
let _e1040 = select(-0.5f, _e732, (_e732 > -0.5f));
let _e1042 = select(_e1038, _e1040, (_e1040 < _e1038));
let _e1047 = global_1.member.member_5.member_3.member_2;
let _e1048 = (_e1047 - 0.5f);
let _e1050 = select(-0.5f, _e738, (_e738 > -0.5f));
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
let _e1108 = (_e1067 + 1i);
let _e1109 = (_e1082 + 1i);
let _e1110 = (_e1097 + 1i);
let _e1117 = global_1.member.member_5.member_7[0u];
let _e1124 = global_1.member.member_5.member_7[1u];
let _e1130 = ((_e1108 >> bitcast<u32>(4i)) + (_e1117 * ((_e1109 >> bitcast<u32>(4i)) + (_e1124 * (_e1110 >> bitcast<u32>(4i))))));
let _e1132 = (bitcast<i32>(_e88) - 1i);
let _e1134 = select(_e1132, _e1130, (_e1130 < _e1132));
let _e1140 = global_2.member[bitcast<u32>(select(0i, _e1134, (_e1134 > 0i)))];
let _e1142 = (_e1108 & 15i);
let _e1145 = ((_e1109 & 15i) * _e1102);
let _e1147 = (bitcast<i32>(_e1140) + ((_e1110 & 15i) * _e1107));
let _e1151 = (_e1145 + _e1102);
let _e1153 = (_e1145 + (2i * _e1102));
let _e1155 = (_e1145 + (3i * _e1102));
let _e1156 = (_e1147 + _e1107);
let _e1158 = (_e1147 + (2i * _e1107));
let _e1160 = (_e1147 + (3i * _e1107));
local_4 = type_18(array<i32, 4>(_e1142, (_e1142 + 1i), (_e1142 + 2i), (_e1142 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e1032 - f32(_e1067)), (_e1042 - f32(_e1082)), (_e1052 - f32(_e1097)));
let _e1171 = (_e1156 + _e1151);
let _e1174 = local_4.member[0u];
let _e1175 = (_e1171 + _e1174);
let _e1177 = select(_e1132, _e1175, (_e1175 < _e1132));
let _e1182 = global_2.member[bitcast<u32>(select(0i, _e1177, (_e1177 > 0i)))];
let _e1183 = bitcast<f32>(_e1182);
let _e1186 = local_4.member[1u];
let _e1187 = (_e1171 + _e1186);
let _e1189 = select(_e1132, _e1187, (_e1187 < _e1132));
let _e1194 = global_2.member[bitcast<u32>(select(0i, _e1189, (_e1189 > 0i)))];
let _e1195 = bitcast<f32>(_e1194);
let _e1198 = local_4.member[2u];
let _e1199 = (_e1171 + _e1198);
let _e1201 = select(_e1132, _e1199, (_e1199 < _e1132));
let _e1206 = global_2.member[bitcast<u32>(select(0i, _e1201, (_e1201 > 0i)))];
let _e1207 = bitcast<f32>(_e1206);
let _e1210 = local_4.member[3u];
let _e1211 = (_e1171 + _e1210);
let _e1213 = select(_e1132, _e1211, (_e1211 < _e1132));
let _e1218 = global_2.member[bitcast<u32>(select(0i, _e1213, (_e1213 > 0i)))];
let _e1220 = local_5[0u];
let _e1223 = (_e1183 + ((_e1195 - _e1183) * _e1220));
let _e1224 = local_5[0u];
let _e1227 = (_e1195 + ((_e1207 - _e1195) * _e1224));
let _e1228 = local_5[0u];
let _e1231 = (_e1207 + ((bitcast<f32>(_e1218) - _e1207) * _e1228));
let _e1232 = (_e1156 + _e1153);
let _e1233 = local_4.member[0u];
let _e1234 = (_e1232 + _e1233);
let _e1236 = select(_e1132, _e1234, (_e1234 < _e1132));
let _e1241 = global_2.member[bitcast<u32>(select(0i, _e1236, (_e1236 > 0i)))];
let _e1242 = bitcast<f32>(_e1241);
let _e1243 = local_4.member[1u];
let _e1244 = (_e1232 + _e1243);
let _e1246 = select(_e1132, _e1244, (_e1244 < _e1132));
let _e1251 = global_2.member[bitcast<u32>(select(0i, _e1246, (_e1246 > 0i)))];
let _e1252 = bitcast<f32>(_e1251);
let _e1253 = local_4.member[2u];
let _e1254 = (_e1232 + _e1253);
let _e1256 = select(_e1132, _e1254, (_e1254 < _e1132));
let _e1261 = global_2.member[bitcast<u32>(select(0i, _e1256, (_e1256 > 0i)))];
let _e1262 = bitcast<f32>(_e1261);
let _e1263 = local_4.member[3u];
let _e1264 = (_e1232 + _e1263);
let _e1266 = select(_e1132, _e1264, (_e1264 < _e1132));
let _e1271 = global_2.member[bitcast<u32>(select(0i, _e1266, (_e1266 > 0i)))];
let _e1273 = local_5[0u];
let _e1277 = local_5[0u];
let _e1280 = (_e1252 + ((_e1262 - _e1252) * _e1277));
let _e1281 = local_5[0u];
let _e1285 = (_e1158 + _e1151);
let _e1286 = local_4.member[0u];
let _e1287 = (_e1285 + _e1286);
let _e1289 = select(_e1132, _e1287, (_e1287 < _e1132));
let _e1294 = global_2.member[bitcast<u32>(select(0i, _e1289, (_e1289 > 0i)))];
let _e1295 = bitcast<f32>(_e1294);
let _e1296 = local_4.member[1u];
let _e1297 = (_e1285 + _e1296);
let _e1299 = select(_e1132, _e1297, (_e1297 < _e1132));
let _e1304 = global_2.member[bitcast<u32>(select(0i, _e1299, (_e1299 > 0i)))];
let _e1305 = bitcast<f32>(_e1304);
let _e1306 = local_4.member[2u];
let _e1307 = (_e1285 + _e1306);
let _e1309 = select(_e1132, _e1307, (_e1307 < _e1132));
let _e1314 = global_2.member[bitcast<u32>(select(0i, _e1309, (_e1309 > 0i)))];
let _e1315 = bitcast<f32>(_e1314);
let _e1316 = local_4.member[3u];
let _e1317 = (_e1285 + _e1316);
let _e1319 = select(_e1132, _e1317, (_e1317 < _e1132));
let _e1324 = global_2.member[bitcast<u32>(select(0i, _e1319, (_e1319 > 0i)))];
let _e1326 = local_5[0u];
let _e1329 = (_e1295 + ((_e1305 - _e1295) * _e1326));
let _e1330 = local_5[0u];
let _e1333 = (_e1305 + ((_e1315 - _e1305) * _e1330));
let _e1334 = local_5[0u];
let _e1337 = (_e1315 + ((bitcast<f32>(_e1324) - _e1315) * _e1334));
let _e1338 = (_e1158 + _e1153);
let _e1339 = local_4.member[0u];
let _e1340 = (_e1338 + _e1339);
let _e1342 = select(_e1132, _e1340, (_e1340 < _e1132));
let _e1347 = global_2.member[bitcast<u32>(select(0i, _e1342, (_e1342 > 0i)))];
let _e1348 = bitcast<f32>(_e1347);
let _e1349 = local_4.member[1u];
let _e1350 = (_e1338 + _e1349);
let _e1352 = select(_e1132, _e1350, (_e1350 < _e1132));
let _e1357 = global_2.member[bitcast<u32>(select(0i, _e1352, (_e1352 > 0i)))];
let _e1358 = bitcast<f32>(_e1357);
let _e1359 = local_4.member[2u];
let _e1360 = (_e1338 + _e1359);
let _e1362 = select(_e1132, _e1360, (_e1360 < _e1132));
let _e1367 = global_2.member[bitcast<u32>(select(0i, _e1362, (_e1362 > 0i)))];
let _e1368 = bitcast<f32>(_e1367);
let _e1369 = local_4.member[3u];
let _e1370 = (_e1338 + _e1369);
let _e1372 = select(_e1132, _e1370, (_e1370 < _e1132));
let _e1377 = global_2.member[bitcast<u32>(select(0i, _e1372, (_e1372 > 0i)))];
let _e1379 = local_5[0u];
let _e1383 = local_5[0u];
let _e1386 = (_e1358 + ((_e1368 - _e1358) * _e1383));
let _e1387 = local_5[0u];
let _e1391 = (_e1156 + _e1145);
let _e1392 = local_4.member[1u];
let _e1393 = (_e1391 + _e1392);
let _e1395 = select(_e1132, _e1393, (_e1393 < _e1132));
let _e1400 = global_2.member[bitcast<u32>(select(0i, _e1395, (_e1395 > 0i)))];
let _e1401 = bitcast<f32>(_e1400);
let _e1402 = local_4.member[2u];
let _e1403 = (_e1391 + _e1402);
let _e1405 = select(_e1132, _e1403, (_e1403 < _e1132));
let _e1410 = global_2.member[bitcast<u32>(select(0i, _e1405, (_e1405 > 0i)))];
let _e1412 = local_5[0u];
let _e1415 = (_e1401 + ((bitcast<f32>(_e1410) - _e1401) * _e1412));
let _e1416 = (_e1156 + _e1155);
let _e1417 = local_4.member[1u];
let _e1418 = (_e1416 + _e1417);
let _e1420 = select(_e1132, _e1418, (_e1418 < _e1132));
let _e1425 = global_2.member[bitcast<u32>(select(0i, _e1420, (_e1420 > 0i)))];
let _e1426 = bitcast<f32>(_e1425);
let _e1427 = local_4.member[2u];
let _e1428 = (_e1416 + _e1427);
let _e1430 = select(_e1132, _e1428, (_e1428 < _e1132));
let _e1435 = global_2.member[bitcast<u32>(select(0i, _e1430, (_e1430 > 0i)))];
let _e1437 = local_5[0u];
let _e1441 = (_e1158 + _e1145);
let _e1442 = local_4.member[1u];
let _e1443 = (_e1441 + _e1442);
let _e1445 = select(_e1132, _e1443, (_e1443 < _e1132));
let _e1450 = global_2.member[bitcast<u32>(select(0i, _e1445, (_e1445 > 0i)))];
let _e1451 = bitcast<f32>(_e1450);
let _e1452 = local_4.member[2u];
let _e1453 = (_e1441 + _e1452);
let _e1455 = select(_e1132, _e1453, (_e1453 < _e1132));
let _e1460 = global_2.member[bitcast<u32>(select(0i, _e1455, (_e1455 > 0i)))];
let _e1462 = local_5[0u];
let _e1465 = (_e1451 + ((bitcast<f32>(_e1460) - _e1451) * _e1462));
let _e1466 = (_e1158 + _e1155);
let _e1467 = local_4.member[1u];
let _e1468 = (_e1466 + _e1467);
let _e1470 = select(_e1132, _e1468, (_e1468 < _e1132));
let _e1475 = global_2.member[bitcast<u32>(select(0i, _e1470, (_e1470 > 0i)))];
let _e1476 = bitcast<f32>(_e1475);
let _e1477 = local_4.member[2u];
let _e1478 = (_e1466 + _e1477);
let _e1480 = select(_e1132, _e1478, (_e1478 < _e1132));
let _e1485 = global_2.member[bitcast<u32>(select(0i, _e1480, (_e1480 > 0i)))];
let _e1487 = local_5[0u];
let _e1491 = (_e1147 + _e1151);
let _e1492 = local_4.member[1u];
let _e1493 = (_e1491 + _e1492);
let _e1495 = select(_e1132, _e1493, (_e1493 < _e1132));
let _e1500 = global_2.member[bitcast<u32>(select(0i, _e1495, (_e1495 > 0i)))];
let _e1501 = bitcast<f32>(_e1500);
let _e1502 = local_4.member[2u];
let _e1503 = (_e1491 + _e1502);
let _e1505 = select(_e1132, _e1503, (_e1503 < _e1132));
let _e1510 = global_2.member[bitcast<u32>(select(0i, _e1505, (_e1505 > 0i)))];
let _e1512 = local_5[0u];
let _e1515 = (_e1501 + ((bitcast<f32>(_e1510) - _e1501) * _e1512));
let _e1516 = (_e1160 + _e1151);
let _e1517 = local_4.member[1u];
let _e1518 = (_e1516 + _e1517);
let _e1520 = select(_e1132, _e1518, (_e1518 < _e1132));
let _e1525 = global_2.member[bitcast<u32>(select(0i, _e1520, (_e1520 > 0i)))];
let _e1526 = bitcast<f32>(_e1525);
let _e1527 = local_4.member[2u];
let _e1528 = (_e1516 + _e1527);
let _e1530 = select(_e1132, _e1528, (_e1528 < _e1132));
let _e1535 = global_2.member[bitcast<u32>(select(0i, _e1530, (_e1530 > 0i)))];
let _e1537 = local_5[0u];
let _e1540 = (_e1526 + ((bitcast<f32>(_e1535) - _e1526) * _e1537));
let _e1541 = (_e1147 + _e1153);
let _e1542 = local_4.member[1u];
let _e1543 = (_e1541 + _e1542);
let _e1545 = select(_e1132, _e1543, (_e1543 < _e1132));
let _e1550 = global_2.member[bitcast<u32>(select(0i, _e1545, (_e1545 > 0i)))];
let _e1551 = bitcast<f32>(_e1550);
let _e1552 = local_4.member[2u];
let _e1553 = (_e1541 + _e1552);
let _e1555 = select(_e1132, _e1553, (_e1553 < _e1132));
let _e1560 = global_2.member[bitcast<u32>(select(0i, _e1555, (_e1555 > 0i)))];
let _e1562 = local_5[0u];
let _e1566 = (_e1160 + _e1153);
let _e1567 = local_4.member[1u];
let _e1568 = (_e1566 + _e1567);
let _e1570 = select(_e1132, _e1568, (_e1568 < _e1132));
let _e1575 = global_2.member[bitcast<u32>(select(0i, _e1570, (_e1570 > 0i)))];
let _e1576 = bitcast<f32>(_e1575);
let _e1577 = local_4.member[2u];
let _e1578 = (_e1566 + _e1577);
let _e1580 = select(_e1132, _e1578, (_e1578 < _e1132));
let _e1585 = global_2.member[bitcast<u32>(select(0i, _e1580, (_e1580 > 0i)))];
let _e1587 = local_5[0u];
let _e1592 = local_5[1u];
let _e1595 = (_e1227 + ((_e1280 - _e1227) * _e1592));
let _e1596 = local_5[1u];
let _e1599 = (_e1333 + ((_e1386 - _e1333) * _e1596));
let _e1600 = local_5[1u];
let _e1603 = (_e1223 + (((_e1242 + ((_e1252 - _e1242) * _e1273)) - _e1223) * _e1600));
let _e1604 = local_5[1u];
let _e1609 = local_5[2u];
let _e1613 = local_5[1u];
let _e1616 = (_e1231 + (((_e1262 + ((bitcast<f32>(_e1271) - _e1262) * _e1281)) - _e1231) * _e1613));
let _e1617 = local_5[1u];
let _e1621 = local_5[2u];
let _e1625 = local_5[1u];
let _e1628 = (_e1415 + ((_e1227 - _e1415) * _e1625));
let _e1629 = local_5[1u];
let _e1633 = local_5[2u];
let _e1637 = local_5[1u];
let _e1640 = (_e1280 + (((_e1426 + ((bitcast<f32>(_e1435) - _e1426) * _e1437)) - _e1280) * _e1637));
let _e1641 = local_5[1u];
let _e1645 = local_5[2u];
let _e1649 = local_5[1u];
let _e1652 = (_e1515 + (((_e1551 + ((bitcast<f32>(_e1560) - _e1551) * _e1562)) - _e1515) * _e1649));
let _e1653 = local_5[2u];
let _e1657 = local_5[1u];
let _e1661 = local_5[2u];
let _e1665 = local_5[2u];
let _e1673 = global_1.member.member_5.member_4.member;
let _e1679 = global_1.member.member_5.member_4.member_1;
let _e1680 = (((_e1595 + ((_e1599 - _e1595) * _e1665)) * _e1673) + _e1679);
let _e1682 = select(0f, _e1680, (_e1680 > 0f));
let _e1684 = select(1f, _e1682, (_e1682 < 1f));
let _e1686 = (((_e1603 + (((_e1329 + (((_e1348 + ((_e1358 - _e1348) * _e1379)) - _e1329) * _e1604)) - _e1603) * _e1609)) * _e1673) + _e1679);
let _e1688 = select(0f, _e1686, (_e1686 > 0f));
let _e1690 = select(1f, _e1688, (_e1688 < 1f));
let _e1692 = (((_e1616 + (((_e1337 + (((_e1368 + ((bitcast<f32>(_e1377) - _e1368) * _e1387)) - _e1337) * _e1617)) - _e1616) * _e1621)) * _e1673) + _e1679);
let _e1694 = select(0f, _e1692, (_e1692 > 0f));
let _e1696 = select(1f, _e1694, (_e1694 < 1f));
let _e1698 = (((_e1628 + (((_e1465 + ((_e1333 - _e1465) * _e1629)) - _e1628) * _e1633)) * _e1673) + _e1679);
let _e1700 = select(0f, _e1698, (_e1698 > 0f));
let _e1702 = select(1f, _e1700, (_e1700 < 1f));
let _e1704 = (((_e1640 + (((_e1386 + (((_e1476 + ((bitcast<f32>(_e1485) - _e1476) * _e1487)) - _e1386) * _e1641)) - _e1640) * _e1645)) * _e1673) + _e1679);
let _e1706 = select(0f, _e1704, (_e1704 > 0f));
let _e1708 = select(1f, _e1706, (_e1706 < 1f));
let _e1710 = (((_e1652 + ((_e1595 - _e1652) * _e1653)) * _e1673) + _e1679);
let _e1712 = select(0f, _e1710, (_e1710 > 0f));
let _e1714 = select(1f, _e1712, (_e1712 < 1f));
let _e1716 = (((_e1599 + (((_e1540 + (((_e1576 + ((bitcast<f32>(_e1585) - _e1576) * _e1587)) - _e1540) * _e1657)) - _e1599) * _e1661)) * _e1673) + _e1679);
let _e1718 = select(0f, _e1716, (_e1716 > 0f));
let _e1720 = select(1f, _e1718, (_e1718 < 1f));
let _e1721 = (_e1684 * 1024f);
let _e1722 = (1024f - 1f);
let _e1724 = select(0f, _e1721, (_e1721 > 0f));
let _e1726 = select(_e1722, _e1724, (_e1724 < _e1722));
let _e1733 = select(0i, select(select(i32(_e1726), i32(-2147483648), (_e1726 < -2147483600f)), 2147483647i, (_e1726 > 2147483500f)), (_e1726 == _e1726));
let _e1737 = (_e1733 - select(0i, 1i, (_e1726 < f32(_e1733))));
let _e1738 = (262147i + _e1737);
let _e1740 = (bitcast<i32>(_e92) - 1i);
let _e1742 = select(_e1740, _e1738, (_e1738 < _e1740));
let _e1748 = global_4.member[bitcast<u32>(select(0i, _e1742, (_e1742 > 0i)))];
let _e1758 = select(_e1740, 262146i, (262146i < _e1740));
let _e1764 = global_4.member[bitcast<u32>(select(0i, _e1758, (_e1758 > 0i)))];
let _e1765 = bitcast<f32>(_e1764);
let _e1766 = (f32((bitcast<i32>((_e1748 & 4095u)) - 2048i)) * _e1765);
let _e1768 = select(_e1740, 262144i, (262144i < _e1740));
let _e1774 = global_4.member[bitcast<u32>(select(0i, _e1768, (_e1768 > 0i)))];
let _e1775 = bitcast<f32>(_e1774);
let _e1777 = select(_e1740, 262145i, (262145i < _e1740));
let _e1783 = global_4.member[bitcast<u32>(select(0i, _e1777, (_e1777 > 0i)))];
let _e1784 = bitcast<f32>(_e1783);
let _e1790 = ((_e1775 + (f32(bitcast<i32>((_e1748 >> bitcast<u32>(12u)))) * _e1784)) + (_e1766 * (_e1721 - f32(_e1737))));
let _e1791 = (_e1766 * 1024f);
if _e740 {
let _e2056 = ((0.5f * (_e1696 - _e1690)) * _e1791);
let _e2057 = ((0.5f * (_e1708 - _e1702)) * _e1791);
let _e2058 = ((0.5f * (_e1720 - _e1714)) * _e1791);
phi_5327_ = type_19(_e1790, vec3<f32>(_e2056, _e2057, _e2058), vec3<f32>((_e2056 * _e1790), (_e2057 * _e1790), (_e2058 * _e1790)));
} else {
let _e1792 = (_e1690 * 1024f);
let _e1794 = select(0f, _e1792, (_e1792 > 0f));
let _e1796 = select(_e1722, _e1794, (_e1794 < _e1722));
let _e1803 = select(0i, select(select(i32(_e1796), i32(-2147483648), (_e1796 < -2147483600f)), 2147483647i, (_e1796 > 2147483500f)), (_e1796 == _e1796));
let _e1807 = (_e1803 - select(0i, 1i, (_e1796 < f32(_e1803))));
let _e1808 = (262147i + _e1807);
let _e1810 = select(_e1740, _e1808, (_e1808 < _e1740));
let _e1816 = global_4.member[bitcast<u32>(select(0i, _e1810, (_e1810 > 0i)))];
let _e1831 = ((_e1775 + (f32(bitcast<i32>((_e1816 >> bitcast<u32>(12u)))) * _e1784)) + ((f32((bitcast<i32>((_e1816 & 4095u)) - 2048i)) * _e1765) * (_e1792 - f32(_e1807))));
let _e1832 = (_e1696 * 1024f);
let _e1834 = select(0f, _e1832, (_e1832 > 0f));
let _e1836 = select(_e1722, _e1834, (_e1834 < _e1722));
let _e1843 = select(0i, select(select(i32(_e1836), i32(-2147483648), (_e1836 < -2147483600f)), 2147483647i, (_e1836 > 2147483500f)), (_e1836 == _e1836));
let _e1847 = (_e1843 - select(0i, 1i, (_e1836 < f32(_e1843))));
let _e1848 = (262147i + _e1847);
let _e1850 = select(_e1740, _e1848, (_e1848 < _e1740));
let _e1856 = global_4.member[bitcast<u32>(select(0i, _e1850, (_e1850 > 0i)))];
let _e1871 = ((_e1775 + (f32(bitcast<i32>((_e1856 >> bitcast<u32>(12u)))) * _e1784)) + ((f32((bitcast<i32>((_e1856 & 4095u)) - 2048i)) * _e1765) * (_e1832 - f32(_e1847))));
let _e1872 = (_e1702 * 1024f);
let _e1874 = select(0f, _e1872, (_e1872 > 0f));
let _e1876 = select(_e1722, _e1874, (_e1874 < _e1722));
let _e1883 = select(0i, select(select(i32(_e1876), i32(-2147483648), (_e1876 < -2147483600f)), 2147483647i, (_e1876 > 2147483500f)), (_e1876 == _e1876));
let _e1887 = (_e1883 - select(0i, 1i, (_e1876 < f32(_e1883))));
let _e1888 = (262147i + _e1887);
let _e1890 = select(_e1740, _e1888, (_e1888 < _e1740));
let _e1896 = global_4.member[bitcast<u32>(select(0i, _e1890, (_e1890 > 0i)))];
let _e1911 = ((_e1775 + (f32(bitcast<i32>((_e1896 >> bitcast<u32>(12u)))) * _e1784)) + ((f32((bitcast<i32>((_e1896 & 4095u)) - 2048i)) * _e1765) * (_e1872 - f32(_e1887))));
let _e1912 = (_e1708 * 1024f);
let _e1914 = select(0f, _e1912, (_e1912 > 0f));
let _e1916 = select(_e1722, _e1914, (_e1914 < _e1722));
let _e1923 = select(0i, select(select(i32(_e1916), i32(-2147483648), (_e1916 < -2147483600f)), 2147483647i, (_e1916 > 2147483500f)), (_e1916 == _e1916));
let _e1927 = (_e1923 - select(0i, 1i, (_e1916 < f32(_e1923))));
let _e1928 = (262147i + _e1927);
let _e1930 = select(_e1740, _e1928, (_e1928 < _e1740));
let _e1936 = global_4.member[bitcast<u32>(select(0i, _e1930, (_e1930 > 0i)))];
let _e1951 = ((_e1775 + (f32(bitcast<i32>((_e1936 >> bitcast<u32>(12u)))) * _e1784)) + ((f32((bitcast<i32>((_e1936 & 4095u)) - 2048i)) * _e1765) * (_e1912 - f32(_e1927))));
let _e1952 = (_e1714 * 1024f);
let _e1954 = select(0f, _e1952, (_e1952 > 0f));
let _e1956 = select(_e1722, _e1954, (_e1954 < _e1722));
let _e1963 = select(0i, select(select(i32(_e1956), i32(-2147483648), (_e1956 < -2147483600f)), 2147483647i, (_e1956 > 2147483500f)), (_e1956 == _e1956));
let _e1967 = (_e1963 - select(0i, 1i, (_e1956 < f32(_e1963))));
let _e1968 = (262147i + _e1967);
let _e1970 = select(_e1740, _e1968, (_e1968 < _e1740));
let _e1976 = global_4.member[bitcast<u32>(select(0i, _e1970, (_e1970 > 0i)))];
let _e1991 = ((_e1775 + (f32(bitcast<i32>((_e1976 >> bitcast<u32>(12u)))) * _e1784)) + ((f32((bitcast<i32>((_e1976 & 4095u)) - 2048i)) * _e1765) * (_e1952 - f32(_e1967))));
let _e1992 = (_e1720 * 1024f);
let _e1994 = select(0f, _e1992, (_e1992 > 0f));
let _e1996 = select(_e1722, _e1994, (_e1994 < _e1722));
let _e2003 = select(0i, select(select(i32(_e1996), i32(-2147483648), (_e1996 < -2147483600f)), 2147483647i, (_e1996 > 2147483500f)), (_e1996 == _e1996));
let _e2007 = (_e2003 - select(0i, 1i, (_e1996 < f32(_e2003))));
let _e2008 = (262147i + _e2007);
let _e2010 = select(_e1740, _e2008, (_e2008 < _e1740));
let _e2016 = global_4.member[bitcast<u32>(select(0i, _e2010, (_e2010 > 0i)))];
let _e2031 = ((_e1775 + (f32(bitcast<i32>((_e2016 >> bitcast<u32>(12u)))) * _e1784)) + ((f32((bitcast<i32>((_e2016 & 4095u)) - 2048i)) * _e1765) * (_e1992 - f32(_e2007))));
let _e2032 = (_e1871 - _e1831);
let _e2034 = (_e1951 - _e1911);
let _e2036 = (_e2031 - _e1991);
phi_5327_ = type_19(_e1790, vec3<f32>((0.5f * _e2032), (0.5f * _e2034), (0.5f * _e2036)), vec3<f32>((0.25f * (_e2032 * (_e1871 + _e1831))), (0.25f * (_e2034 * (_e1951 + _e1911))), (0.25f * (_e2036 * (_e2031 + _e1991)))));
}
let _e2066 = phi_5327_;
let _e2081 = select(0f, 1f, ((((((_e726 >= -0.5f) && (_e726 <= _e1028)) && (_e732 >= -0.5f)) && (_e732 <= _e1038)) && (_e738 >= -0.5f)) && (_e738 <= _e1048)));
let _e2083 = (0.5f * (_e1696 - _e1690));
let _e2085 = (0.5f * (_e1708 - _e1702));
let _e2087 = (0.5f * (_e1720 - _e1714));
let _e2092 = global_1.member.member_5.member.member;
let _e2098 = global_1.member.member_5.member_1.member;
let _e2105 = global_1.member.member_5.member_2.member;
let _e2112 = global_1.member.member_5.member.member_1;
let _e2118 = global_1.member.member_5.member_1.member_1;
let _e2125 = global_1.member.member_5.member_2.member_1;
let _e2132 = global_1.member.member_5.member.member_2;
let _e2138 = global_1.member.member_5.member_1.member_2;
let _e2145 = global_1.member.member_5.member_2.member_2;
phi_6647_ = type_20(_e1684, vec3<f32>(((((_e2092 * _e2083) + (_e2098 * _e2085)) + (_e2105 * _e2087)) * _e2081), ((((_e2112 * _e2083) + (_e2118 * _e2085)) + (_e2125 * _e2087)) * _e2081), ((((_e2132 * _e2083) + (_e2138 * _e2085)) + (_e2145 * _e2087)) * _e2081)), _e2066.member, vec3<f32>(((((_e2092 * _e2066.member_2.x) + (_e2098 * _e2066.member_2.y)) + (_e2105 * _e2066.member_2.z)) * _e2081), ((((_e2112 * _e2066.member_2.x) + (_e2118 * _e2066.member_2.y)) + (_e2125 * _e2066.member_2.z)) * _e2081), ((((_e2132 * _e2066.member_2.x) + (_e2138 * _e2066.member_2.y)) + (_e2145 * _e2066.member_2.z)) * _e2081)), vec3<f32>(((((_e2092 * _e2066.member_1.x) + (_e2098 * _e2066.member_1.y)) + (_e2105 * _e2066.member_1.z)) * _e2081), ((((_e2112 * _e2066.member_1.x) + (_e2118 * _e2066.member_1.y)) + (_e2125 * _e2066.member_1.z)) * _e2081), ((((_e2132 * _e2066.member_1.x) + (_e2138 * _e2066.member_1.y)) + (_e2145 * _e2066.member_1.z)) * _e2081)));
} else {
let _e748 = global_1.member.member_5.member_3.member;
let _e749 = (_e748 - 0.5f);
let _e751 = select(-0.5f, _e726, (_e726 > -0.5f));
let _e753 = select(_e749, _e751, (_e751 < _e749));
let _e758 = global_1.member.member_5.member_3.member_1;
let _e759 = (_e758 - 0.5f);
let _e761 = select(-0.5f, _e732, (_e732 > -0.5f));
let _e763 = select(_e759, _e761, (_e761 < _e759));
let _e768 = global_1.member.member_5.member_3.member_2;
let _e769 = (_e768 - 0.5f);
let _e771 = select(-0.5f, _e738, (_e738 > -0.5f));
let _e773 = select(_e769, _e771, (_e771 < _e769));
let _e775 = select(-1f, _e753, (_e753 > -1f));
let _e777 = select(_e748, _e775, (_e775 < _e748));
let _e784 = select(0i, select(select(i32(_e777), i32(-2147483648), (_e777 < -2147483600f)), 2147483647i, (_e777 > 2147483500f)), (_e777 == _e777));
let _e788 = (_e784 - select(0i, 1i, (_e777 < f32(_e784))));
let _e790 = select(-1f, _e763, (_e763 > -1f));
let _e792 = select(_e758, _e790, (_e790 < _e758));
let _e799 = select(0i, select(select(i32(_e792), i32(-2147483648), (_e792 < -2147483600f)), 2147483647i, (_e792 > 2147483500f)), (_e792 == _e792));
let _e803 = (_e799 - select(0i, 1i, (_e792 < f32(_e799))));
let _e805 = select(-1f, _e773, (_e773 > -1f));
let _e807 = select(_e768, _e805, (_e805 < _e768));
let _e814 = select(0i, select(select(i32(_e807), i32(-2147483648), (_e807 < -2147483600f)), 2147483647i, (_e807 > 2147483500f)), (_e807 == _e807));
let _e818 = (_e814 - select(0i, 1i, (_e807 < f32(_e814))));
let _e823 = global_1.member.member_5.member_5[0u];
let _e828 = global_1.member.member_5.member_5[1u];
let _e829 = (_e788 + 1i);
let _e830 = (_e803 + 1i);
let _e831 = (_e818 + 1i);
let _e838 = global_1.member.member_5.member_7[0u];
let _e845 = global_1.member.member_5.member_7[1u];
let _e851 = ((_e829 >> bitcast<u32>(4i)) + (_e838 * ((_e830 >> bitcast<u32>(4i)) + (_e845 * (_e831 >> bitcast<u32>(4i))))));
let _e853 = (bitcast<i32>(_e88) - 1i);
let _e855 = select(_e853, _e851, (_e851 < _e853));
let _e861 = global_2.member[bitcast<u32>(select(0i, _e855, (_e855 > 0i)))];
let _e863 = (_e829 & 15i);
let _e866 = ((_e830 & 15i) * _e823);
let _e868 = (bitcast<i32>(_e861) + ((_e831 & 15i) * _e828));
let _e872 = (_e866 + _e823);
let _e874 = (_e866 + (2i * _e823));
let _e875 = (_e868 + _e828);
let _e877 = (_e868 + (2i * _e828));
local_2 = type_18(array<i32, 4>(_e863, (_e863 + 1i), (_e863 + 2i), (_e863 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e753 - f32(_e788)), (_e763 - f32(_e803)), (_e773 - f32(_e818)));
let _e888 = (_e875 + _e872);
let _e891 = local_2.member[1u];
let _e892 = (_e888 + _e891);
let _e894 = select(_e853, _e892, (_e892 < _e853));
let _e899 = global_2.member[bitcast<u32>(select(0i, _e894, (_e894 > 0i)))];
let _e900 = bitcast<f32>(_e899);
let _e903 = local_2.member[2u];
let _e904 = (_e888 + _e903);
let _e906 = select(_e853, _e904, (_e904 < _e853));
let _e911 = global_2.member[bitcast<u32>(select(0i, _e906, (_e906 > 0i)))];
let _e913 = local_3[0u];
let _e916 = (_e900 + ((bitcast<f32>(_e911) - _e900) * _e913));
let _e917 = (_e875 + _e874);
let _e918 = local_2.member[1u];
let _e919 = (_e917 + _e918);
let _e921 = select(_e853, _e919, (_e919 < _e853));
let _e926 = global_2.member[bitcast<u32>(select(0i, _e921, (_e921 > 0i)))];
let _e927 = bitcast<f32>(_e926);
let _e928 = local_2.member[2u];
let _e929 = (_e917 + _e928);
let _e931 = select(_e853, _e929, (_e929 < _e853));
let _e936 = global_2.member[bitcast<u32>(select(0i, _e931, (_e931 > 0i)))];
let _e938 = local_3[0u];
let _e943 = local_3[1u];
let _e946 = (_e916 + (((_e927 + ((bitcast<f32>(_e936) - _e927) * _e938)) - _e916) * _e943));
let _e947 = (_e877 + _e872);
let _e948 = local_2.member[1u];
let _e949 = (_e947 + _e948);
let _e951 = select(_e853, _e949, (_e949 < _e853));
let _e956 = global_2.member[bitcast<u32>(select(0i, _e951, (_e951 > 0i)))];
let _e957 = bitcast<f32>(_e956);
let _e958 = local_2.member[2u];
let _e959 = (_e947 + _e958);
let _e961 = select(_e853, _e959, (_e959 < _e853));
let _e966 = global_2.member[bitcast<u32>(select(0i, _e961, (_e961 > 0i)))];
let _e968 = local_3[0u];
let _e971 = (_e957 + ((bitcast<f32>(_e966) - _e957) * _e968));
let _e972 = (_e877 + _e874);
let _e973 = local_2.member[1u];
let _e974 = (_e972 + _e973);
let _e976 = select(_e853, _e974, (_e974 < _e853));
let _e981 = global_2.member[bitcast<u32>(select(0i, _e976, (_e976 > 0i)))];
let _e982 = bitcast<f32>(_e981);
let _e983 = local_2.member[2u];
let _e984 = (_e972 + _e983);
let _e986 = select(_e853, _e984, (_e984 < _e853));
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
let _e2198 = phi_6647_;
let _e2203 = global_1.member.member_5.member_3.member;
let _e2204 = (_e2203 - 0.5f);
let _e2206 = select(-0.5f, _e684, (_e684 > -0.5f));
let _e2208 = select(_e2204, _e2206, (_e2206 < _e2204));
let _e2213 = global_1.member.member_5.member_3.member_1;
let _e2214 = (_e2213 - 0.5f);
let _e2216 = select(-0.5f, _e702, (_e702 > -0.5f));
let _e2218 = select(_e2214, _e2216, (_e2216 < _e2214));
let _e2223 = global_1.member.member_5.member_3.member_2;
let _e2224 = (_e2223 - 0.5f);
let _e2226 = select(-0.5f, _e720, (_e720 > -0.5f));
let _e2228 = select(_e2224, _e2226, (_e2226 < _e2224));
let _e2230 = select(-1f, _e2208, (_e2208 > -1f));
let _e2232 = select(_e2203, _e2230, (_e2230 < _e2203));
let _e2239 = select(0i, select(select(i32(_e2232), i32(-2147483648), (_e2232 < -2147483600f)), 2147483647i, (_e2232 > 2147483500f)), (_e2232 == _e2232));
let _e2243 = (_e2239 - select(0i, 1i, (_e2232 < f32(_e2239))));
let _e2245 = select(-1f, _e2218, (_e2218 > -1f));
let _e2247 = select(_e2213, _e2245, (_e2245 < _e2213));
let _e2254 = select(0i, select(select(i32(_e2247), i32(-2147483648), (_e2247 < -2147483600f)), 2147483647i, (_e2247 > 2147483500f)), (_e2247 == _e2247));
let _e2258 = (_e2254 - select(0i, 1i, (_e2247 < f32(_e2254))));
let _e2260 = select(-1f, _e2228, (_e2228 > -1f));
let _e2262 = select(_e2223, _e2260, (_e2260 < _e2223));
let _e2269 = select(0i, select(select(i32(_e2262), i32(-2147483648), (_e2262 < -2147483600f)), 2147483647i, (_e2262 > 2147483500f)), (_e2262 == _e2262));
let _e2273 = (_e2269 - select(0i, 1i, (_e2262 < f32(_e2269))));
let _e2278 = global_1.member.member_5.member_5[0u];
let _e2283 = global_1.member.member_5.member_5[1u];
let _e2284 = (_e2243 + 1i);
let _e2285 = (_e2258 + 1i);
let _e2286 = (_e2273 + 1i);
let _e2293 = global_1.member.member_5.member_7[0u];
let _e2300 = global_1.member.member_5.member_7[1u];
let _e2306 = ((_e2284 >> bitcast<u32>(4i)) + (_e2293 * ((_e2285 >> bitcast<u32>(4i)) + (_e2300 * (_e2286 >> bitcast<u32>(4i))))));
let _e2308 = (bitcast<i32>(_e88) - 1i);
let _e2310 = select(_e2308, _e2306, (_e2306 < _e2308));
let _e2316 = global_2.member[bitcast<u32>(select(0i, _e2310, (_e2310 > 0i)))];
let _e2318 = (_e2284 & 15i);
let _e2321 = ((_e2285 & 15i) * _e2278);
let _e2323 = (bitcast<i32>(_e2316) + ((_e2286 & 15i) * _e2283));
let _e2327 = (_e2321 + _e2278);
let _e2329 = (_e2321 + (2i * _e2278));
let _e2330 = (_e2323 + _e2283);
let _e2332 = (_e2323 + (2i * _e2283));
local = type_18(array<i32, 4>(_e2318, (_e2318 + 1i), (_e2318 + 2i), (_e2318 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = vec3<f32>((_e2208 - f32(_e2243)), (_e2218 - f32(_e2258)), (_e2228 - f32(_e2273)));
let _e2343 = (_e2330 + _e2327);
let _e2346 = local.member[1u];
let _e2347 = (_e2343 + _e2346);
let _e2349 = select(_e2308, _e2347, (_e2347 < _e2308));
let _e2354 = global_2.member[bitcast<u32>(select(0i, _e2349, (_e2349 > 0i)))];
let _e2355 = bitcast<f32>(_e2354);
let _e2358 = local.member[2u];
let _e2359 = (_e2343 + _e2358);
let _e2361 = select(_e2308, _e2359, (_e2359 < _e2308));
let _e2366 = global_2.member[bitcast<u32>(select(0i, _e2361, (_e2361 > 0i)))];
let _e2368 = local_1[0u];
let _e2371 = (_e2355 + ((bitcast<f32>(_e2366) - _e2355) * _e2368));
let _e2372 = (_e2330 + _e2329);
let _e2373 = local.member[1u];
let _e2374 = (_e2372 + _e2373);
let _e2376 = select(_e2308, _e2374, (_e2374 < _e2308));
let _e2381 = global_2.member[bitcast<u32>(select(0i, _e2376, (_e2376 > 0i)))];
let _e2382 = bitcast<f32>(_e2381);
let _e2383 = local.member[2u];
let _e2384 = (_e2372 + _e2383);
let _e2386 = select(_e2308, _e2384, (_e2384 < _e2308));
let _e2391 = global_2.member[bitcast<u32>(select(0i, _e2386, (_e2386 > 0i)))];
let _e2393 = local_1[0u];
let _e2398 = local_1[1u];
let _e2401 = (_e2371 + (((_e2382 + ((bitcast<f32>(_e2391) - _e2382) * _e2393)) - _e2371) * _e2398));
let _e2402 = (_e2332 + _e2327);
let _e2403 = local.member[1u];
let _e2404 = (_e2402 + _e2403);
let _e2406 = select(_e2308, _e2404, (_e2404 < _e2308));
let _e2411 = global_2.member[bitcast<u32>(select(0i, _e2406, (_e2406 > 0i)))];
let _e2412 = bitcast<f32>(_e2411);
let _e2413 = local.member[2u];
let _e2414 = (_e2402 + _e2413);
let _e2416 = select(_e2308, _e2414, (_e2414 < _e2308));
let _e2421 = global_2.member[bitcast<u32>(select(0i, _e2416, (_e2416 > 0i)))];
let _e2423 = local_1[0u];
let _e2426 = (_e2412 + ((bitcast<f32>(_e2421) - _e2412) * _e2423));
let _e2427 = (_e2332 + _e2329);
let _e2428 = local.member[1u];
let _e2429 = (_e2427 + _e2428);
let _e2431 = select(_e2308, _e2429, (_e2429 < _e2308));
let _e2436 = global_2.member[bitcast<u32>(select(0i, _e2431, (_e2431 > 0i)))];
let _e2437 = bitcast<f32>(_e2436);
let _e2438 = local.member[2u];
let _e2439 = (_e2427 + _e2438);
let _e2441 = select(_e2308, _e2439, (_e2439 < _e2308));
let _e2446 = global_2.member[bitcast<u32>(select(0i, _e2441, (_e2441 > 0i)))];
let _e2448 = local_1[0u];
let _e2452 = local_1[1u];
let _e2457 = local_1[2u];
let _e2465 = global_1.member.member_5.member_4.member;
let _e2471 = global_1.member.member_5.member_4.member_1;
let _e2472 = (((_e2401 + (((_e2426 + (((_e2437 + ((bitcast<f32>(_e2446) - _e2437) * _e2448)) - _e2426) * _e2452)) - _e2401) * _e2457)) * _e2465) + _e2471);
let _e2474 = select(0f, _e2472, (_e2472 > 0f));
let _e2476 = select(1f, _e2474, (_e2474 < 1f));
let _e2480 = global_1.member.member[3u];
if ((_e2480 & 16u) == 0u) {
phi_8132_ = type_21(1f, 1f, 1f);
} else {
let _e2485 = global_1.member.member_18;
let _e2489 = global_1.member.member_22.member;
let _e2499 = ((((_e2485.member * _e638) + (_e2485.member_1 * _e651)) + (_e2485.member_2 * _e616)) + _e2485.member_3);
let _e2505 = ((((_e2485.member * _e661) + (_e2485.member_1 * _e666)) + (_e2485.member_2 * _e655)) + _e2485.member_3);
let _e2507 = select(_e2505, _e2499, (_e2499 < _e2505));
let _e2509 = select(_e2505, _e2499, (_e2499 > _e2505));
let _e2511 = (_e2509 - _e2507);
let _e2514 = (-(_e2507) / select(1e-30f, _e2511, (_e2511 > 1e-30f)));
let _e2516 = select(0f, _e2514, (_e2514 > 0f));
let _e2522 = select(select(select(1f, _e2516, (_e2516 < 1f)), 1f, (_e2509 <= 0f)), 0f, (_e2507 > 0f));
let _e2524 = (_e2489 > 0.5f);
let _e2533 = global_1.member.member_19;
let _e2537 = global_1.member.member_22.member_1;
let _e2547 = ((((_e2533.member * _e638) + (_e2533.member_1 * _e651)) + (_e2533.member_2 * _e616)) + _e2533.member_3);
let _e2553 = ((((_e2533.member * _e661) + (_e2533.member_1 * _e666)) + (_e2533.member_2 * _e655)) + _e2533.member_3);
let _e2555 = select(_e2553, _e2547, (_e2547 < _e2553));
let _e2557 = select(_e2553, _e2547, (_e2547 > _e2553));
let _e2559 = (_e2557 - _e2555);
let _e2562 = (-(_e2555) / select(1e-30f, _e2559, (_e2559 > 1e-30f)));
let _e2564 = select(0f, _e2562, (_e2562 > 0f));
let _e2570 = select(select(select(1f, _e2564, (_e2564 < 1f)), 1f, (_e2557 <= 0f)), 0f, (_e2555 > 0f));
let _e2572 = (_e2537 > 0.5f);
let _e2581 = global_1.member.member_20;
let _e2585 = global_1.member.member_22.member_2;
let _e2595 = ((((_e2581.member * _e638) + (_e2581.member_1 * _e651)) + (_e2581.member_2 * _e616)) + _e2581.member_3);
let _e2601 = ((((_e2581.member * _e661) + (_e2581.member_1 * _e666)) + (_e2581.member_2 * _e655)) + _e2581.member_3);
let _e2603 = select(_e2601, _e2595, (_e2595 < _e2601));
let _e2605 = select(_e2601, _e2595, (_e2595 > _e2601));
let _e2607 = (_e2605 - _e2603);
let _e2610 = (-(_e2603) / select(1e-30f, _e2607, (_e2607 > 1e-30f)));
let _e2612 = select(0f, _e2610, (_e2610 > 0f));
let _e2618 = select(select(select(1f, _e2612, (_e2612 < 1f)), 1f, (_e2605 <= 0f)), 0f, (_e2603 > 0f));
let _e2620 = (_e2585 > 0.5f);
let _e2629 = global_1.member.member_21;
let _e2633 = global_1.member.member_22.member_3;
let _e2643 = ((((_e2629.member * _e638) + (_e2629.member_1 * _e651)) + (_e2629.member_2 * _e616)) + _e2629.member_3);
let _e2649 = ((((_e2629.member * _e661) + (_e2629.member_1 * _e666)) + (_e2629.member_2 * _e655)) + _e2629.member_3);
let _e2651 = select(_e2649, _e2643, (_e2643 < _e2649));
let _e2653 = select(_e2649, _e2643, (_e2643 > _e2649));
let _e2655 = (_e2653 - _e2651);
let _e2658 = (-(_e2651) / select(1e-30f, _e2655, (_e2655 > 1e-30f)));
let _e2660 = select(0f, _e2658, (_e2658 > 0f));
let _e2666 = select(select(select(1f, _e2660, (_e2660 < 1f)), 1f, (_e2653 <= 0f)), 0f, (_e2651 > 0f));
let _e2668 = (_e2633 > 0.5f);
phi_8132_ = type_21(((((1f * _e2522) * _e2570) * _e2618) * _e2666), ((((1f * select(1f, _e2522, _e2524)) * select(1f, _e2570, _e2572)) * select(1f, _e2618, _e2620)) * select(1f, _e2666, _e2668)), ((((1f * select(1f, 0f, (_e2524 && (_e2505 > 0f)))) * select(1f, 0f, (_e2572 && (_e2553 > 0f)))) * select(1f, 0f, (_e2620 && (_e2601 > 0f)))) * select(1f, 0f, (_e2668 && (_e2649 > 0f)))));
}
let _e2677 = phi_8132_;
let _e2678 = (_e726 - _e684);
let _e2682 = (bitcast<f32>((bitcast<u32>(_e2678) & 2147483647u)) < 1e-12f);
let _e2684 = (1f / select(_e2678, 1f, _e2682));
let _e2686 = ((-0.5f - _e684) * _e2684);
let _e2688 = ((_e2204 - _e684) * _e2684);
let _e2694 = select(_e2688, _e2686, (_e2686 < _e2688));
let _e2696 = select(0f, _e2694, (_e2694 > 0f));
let _e2699 = select(select(1f, _e2696, (_e2696 < 1f)), select(2f, 0f, ((_e684 >= -0.5f) && (_e684 <= _e2204))), _e2682);
let _e2701 = select(_e2688, _e2686, (_e2686 > _e2688));
let _e2703 = select(0f, _e2701, (_e2701 > 0f));
let _e2706 = select(select(1f, _e2703, (_e2703 < 1f)), 1f, _e2682);
let _e2707 = (_e732 - _e702);
let _e2711 = (bitcast<f32>((bitcast<u32>(_e2707) & 2147483647u)) < 1e-12f);
let _e2713 = (1f / select(_e2707, 1f, _e2711));
let _e2715 = ((-0.5f - _e702) * _e2713);
let _e2717 = ((_e2214 - _e702) * _e2713);
let _e2723 = select(_e2717, _e2715, (_e2715 < _e2717));
let _e2725 = select(0f, _e2723, (_e2723 > 0f));
let _e2728 = select(select(1f, _e2725, (_e2725 < 1f)), select(2f, 0f, ((_e702 >= -0.5f) && (_e702 <= _e2214))), _e2711);
let _e2730 = select(_e2717, _e2715, (_e2715 > _e2717));
let _e2732 = select(0f, _e2730, (_e2730 > 0f));
let _e2735 = select(select(1f, _e2732, (_e2732 < 1f)), 1f, _e2711);
let _e2736 = (_e738 - _e720);
let _e2740 = (bitcast<f32>((bitcast<u32>(_e2736) & 2147483647u)) < 1e-12f);
let _e2742 = (1f / select(_e2736, 1f, _e2740));
let _e2744 = ((-0.5f - _e720) * _e2742);
let _e2746 = ((_e2224 - _e720) * _e2742);
let _e2752 = select(_e2746, _e2744, (_e2744 < _e2746));
let _e2754 = select(0f, _e2752, (_e2752 > 0f));
let _e2757 = select(select(1f, _e2754, (_e2754 < 1f)), select(2f, 0f, ((_e720 >= -0.5f) && (_e720 <= _e2224))), _e2740);
let _e2759 = select(_e2746, _e2744, (_e2744 > _e2746));
let _e2761 = select(0f, _e2759, (_e2759 > 0f));
let _e2764 = select(select(1f, _e2761, (_e2761 < 1f)), 1f, _e2740);
let _e2766 = select(_e2735, _e2706, (_e2706 < _e2735));
let _e2770 = select(_e2728, _e2699, (_e2699 > _e2728));
let _e2773 = (select(_e2764, _e2766, (_e2766 < _e2764)) - select(_e2757, _e2770, (_e2770 > _e2757)));
let _e2776 = (_e661 - _e638);
let _e2777 = (_e666 - _e651);
let _e2778 = (_e655 - _e616);
let _e2783 = (((_e2776 * _e2776) + (_e2777 * _e2777)) + (_e2778 * _e2778));
let _e2791 = global_1.member.member_4.member_3;
let _e2792 = ((sqrt(select(0f, _e2783, (_e2783 > 0f))) * select(0f, _e2773, (_e2773 > 0f))) * _e2791);
if (_e583 >= 3u) {
let _e3245 = (_e2476 * 255f);
let _e3246 = (_e2198.member * 255f);
let _e3247 = (255f - 1f);
let _e3249 = select(0f, _e3245, (_e3245 > 0f));
let _e3251 = select(_e3247, _e3249, (_e3249 < _e3247));
let _e3258 = select(0i, select(select(i32(_e3251), i32(-2147483648), (_e3251 < -2147483600f)), 2147483647i, (_e3251 > 2147483500f)), (_e3251 == _e3251));
let _e3262 = (_e3258 - select(0i, 1i, (_e3251 < f32(_e3258))));
let _e3264 = select(0f, _e3246, (_e3246 > 0f));
let _e3266 = select(_e3247, _e3264, (_e3264 < _e3247));
let _e3273 = select(0i, select(select(i32(_e3266), i32(-2147483648), (_e3266 < -2147483600f)), 2147483647i, (_e3266 > 2147483500f)), (_e3266 == _e3266));
let _e3277 = (_e3273 - select(0i, 1i, (_e3266 < f32(_e3273))));
let _e3280 = (((_e3262 * 256i) + _e3277) * 4i);
let _e3284 = (_e3246 - f32(_e3277));
let _e3286 = (bitcast<i32>(_e92) - 1i);
let _e3288 = select(_e3286, _e3280, (_e3280 < _e3286));
let _e3294 = global_4.member[bitcast<u32>(select(0i, _e3288, (_e3288 > 0i)))];
let _e3295 = (_e3280 + 4i);
let _e3297 = select(_e3286, _e3295, (_e3295 < _e3286));
let _e3303 = global_4.member[bitcast<u32>(select(0i, _e3297, (_e3297 > 0i)))];
let _e3304 = (_e3280 + 1024i);
let _e3306 = select(_e3286, _e3304, (_e3304 < _e3286));
let _e3312 = global_4.member[bitcast<u32>(select(0i, _e3306, (_e3306 > 0i)))];
let _e3313 = (_e3280 + 1028i);
let _e3315 = select(_e3286, _e3313, (_e3313 < _e3286));
let _e3321 = global_4.member[bitcast<u32>(select(0i, _e3315, (_e3315 > 0i)))];
let _e3326 = (bitcast<f32>(((_e3294 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3334 = (_e3326 + (((bitcast<f32>(((_e3303 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3326) * _e3284));
let _e3339 = (bitcast<f32>(((_e3312 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3350 = (_e3334 + (((_e3339 + (((bitcast<f32>(((_e3321 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3339) * _e3284)) - _e3334) * (_e3245 - f32(_e3262))));
let _e3354 = -((_e3350 * (_e2792 * _e2677.member)));
let _e3356 = select(-87f, _e3354, (_e3354 > -87f));
let _e3358 = select(88f, _e3356, (_e3356 < 88f));
let _e3360 = ((_e3358 * 1.442695f) + 0.5f);
let _e3362 = select(-127f, _e3360, (_e3360 > -127f));
let _e3364 = select(128f, _e3362, (_e3362 < 128f));
let _e3371 = select(0i, select(select(i32(_e3364), i32(-2147483648), (_e3364 < -2147483600f)), 2147483647i, (_e3364 > 2147483500f)), (_e3364 == _e3364));
let _e3375 = (_e3371 - select(0i, 1i, (_e3364 < f32(_e3371))));
let _e3376 = f32(_e3375);
let _e3380 = ((_e3358 - (_e3376 * 0.6933594f)) - (_e3376 * -2.1219444e-4f));
let _e3400 = ((1f + (_e3380 * (1f + (_e3380 * (0.5f + (_e3380 * (0.16666667f + (_e3380 * (0.041666668f + (_e3380 * (0.008333334f + (_e3380 * (0.001388889f + (_e3380 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3375 + 127i)) << bitcast<u32>(23i))));
let _e3401 = (1f - _e3400);
phi_9242_ = type_22(_e3400, _e3401, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e3401 / select(1e-12f, _e3350, (_e3350 > 1e-12f))))));
} else {
let _e2795 = (_e2476 * 255f);
let _e2796 = (_e2198.member * 255f);
let _e2797 = (255f - 1f);
let _e2799 = select(0f, _e2795, (_e2795 > 0f));
let _e2801 = select(_e2797, _e2799, (_e2799 < _e2797));
let _e2808 = select(0i, select(select(i32(_e2801), i32(-2147483648), (_e2801 < -2147483600f)), 2147483647i, (_e2801 > 2147483500f)), (_e2801 == _e2801));
let _e2812 = (_e2808 - select(0i, 1i, (_e2801 < f32(_e2808))));
let _e2814 = select(0f, _e2796, (_e2796 > 0f));
let _e2816 = select(_e2797, _e2814, (_e2814 < _e2797));
let _e2823 = select(0i, select(select(i32(_e2816), i32(-2147483648), (_e2816 < -2147483600f)), 2147483647i, (_e2816 > 2147483500f)), (_e2816 == _e2816));
let _e2827 = (_e2823 - select(0i, 1i, (_e2816 < f32(_e2823))));
let _e2830 = (((_e2812 * 256i) + _e2827) * 4i);
let _e2832 = (_e2795 - f32(_e2812));
let _e2834 = (_e2796 - f32(_e2827));
let _e2836 = (bitcast<i32>(_e92) - 1i);
let _e2838 = select(_e2836, _e2830, (_e2830 < _e2836));
let _e2844 = global_4.member[bitcast<u32>(select(0i, _e2838, (_e2838 > 0i)))];
let _e2845 = (_e2830 + 4i);
let _e2847 = select(_e2836, _e2845, (_e2845 < _e2836));
let _e2853 = global_4.member[bitcast<u32>(select(0i, _e2847, (_e2847 > 0i)))];
let _e2854 = (_e2830 + 1024i);
let _e2856 = select(_e2836, _e2854, (_e2854 < _e2836));
let _e2862 = global_4.member[bitcast<u32>(select(0i, _e2856, (_e2856 > 0i)))];
let _e2863 = (_e2830 + 1028i);
let _e2865 = select(_e2836, _e2863, (_e2863 < _e2836));
let _e2871 = global_4.member[bitcast<u32>(select(0i, _e2865, (_e2865 > 0i)))];
let _e2876 = (bitcast<f32>(((_e2844 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2884 = (_e2876 + (((bitcast<f32>(((_e2853 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2876) * _e2834));
let _e2889 = (bitcast<f32>(((_e2862 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2900 = (_e2884 + (((_e2889 + (((bitcast<f32>(((_e2871 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2889) * _e2834)) - _e2884) * _e2832));
let _e2913 = (bitcast<f32>((((_e2844 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2921 = (_e2913 + (((bitcast<f32>((((_e2853 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2913) * _e2834));
let _e2926 = (bitcast<f32>((((_e2862 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2938 = (_e2830 + 1i);
let _e2940 = select(_e2836, _e2938, (_e2938 < _e2836));
let _e2946 = global_4.member[bitcast<u32>(select(0i, _e2940, (_e2940 > 0i)))];
let _e2947 = (_e2830 + 5i);
let _e2949 = select(_e2836, _e2947, (_e2947 < _e2836));
let _e2955 = global_4.member[bitcast<u32>(select(0i, _e2949, (_e2949 > 0i)))];
let _e2956 = (_e2830 + 1025i);
let _e2958 = select(_e2836, _e2956, (_e2956 < _e2836));
let _e2964 = global_4.member[bitcast<u32>(select(0i, _e2958, (_e2958 > 0i)))];
let _e2965 = (_e2830 + 1029i);
let _e2967 = select(_e2836, _e2965, (_e2965 < _e2836));
let _e2973 = global_4.member[bitcast<u32>(select(0i, _e2967, (_e2967 > 0i)))];
let _e2978 = (bitcast<f32>(((_e2946 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2986 = (_e2978 + (((bitcast<f32>(((_e2955 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2978) * _e2834));
let _e2991 = (bitcast<f32>(((_e2964 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3015 = (bitcast<f32>((((_e2946 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3023 = (_e3015 + (((bitcast<f32>((((_e2955 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3015) * _e2834));
let _e3028 = (bitcast<f32>((((_e2964 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3043 = (_e2792 * _e2677.member_1);
let _e3045 = -(((_e2921 + (((_e2926 + (((bitcast<f32>((((_e2871 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2926) * _e2834)) - _e2921) * _e2832)) * _e3043));
let _e3047 = select(-87f, _e3045, (_e3045 > -87f));
let _e3049 = select(88f, _e3047, (_e3047 < 88f));
let _e3051 = ((_e3049 * 1.442695f) + 0.5f);
let _e3053 = select(-127f, _e3051, (_e3051 > -127f));
let _e3055 = select(128f, _e3053, (_e3053 < 128f));
let _e3062 = select(0i, select(select(i32(_e3055), i32(-2147483648), (_e3055 < -2147483600f)), 2147483647i, (_e3055 > 2147483500f)), (_e3055 == _e3055));
let _e3066 = (_e3062 - select(0i, 1i, (_e3055 < f32(_e3062))));
let _e3067 = f32(_e3066);
let _e3071 = ((_e3049 - (_e3067 * 0.6933594f)) - (_e3067 * -2.1219444e-4f));
let _e3093 = -(((_e2986 + (((_e2991 + (((bitcast<f32>(((_e2973 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2991) * _e2834)) - _e2986) * _e2832)) * _e3043));
let _e3095 = select(-87f, _e3093, (_e3093 > -87f));
let _e3097 = select(88f, _e3095, (_e3095 < 88f));
let _e3099 = ((_e3097 * 1.442695f) + 0.5f);
let _e3101 = select(-127f, _e3099, (_e3099 > -127f));
let _e3103 = select(128f, _e3101, (_e3101 < 128f));
let _e3110 = select(0i, select(select(i32(_e3103), i32(-2147483648), (_e3103 < -2147483600f)), 2147483647i, (_e3103 > 2147483500f)), (_e3103 == _e3103));
let _e3114 = (_e3110 - select(0i, 1i, (_e3103 < f32(_e3110))));
let _e3115 = f32(_e3114);
let _e3119 = ((_e3097 - (_e3115 * 0.6933594f)) - (_e3115 * -2.1219444e-4f));
let _e3141 = -(((_e3023 + (((_e3028 + (((bitcast<f32>((((_e2973 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3028) * _e2834)) - _e3023) * _e2832)) * _e3043));
let _e3143 = select(-87f, _e3141, (_e3141 > -87f));
let _e3145 = select(88f, _e3143, (_e3143 < 88f));
let _e3147 = ((_e3145 * 1.442695f) + 0.5f);
let _e3149 = select(-127f, _e3147, (_e3147 > -127f));
let _e3151 = select(128f, _e3149, (_e3149 < 128f));
let _e3158 = select(0i, select(select(i32(_e3151), i32(-2147483648), (_e3151 < -2147483600f)), 2147483647i, (_e3151 > 2147483500f)), (_e3151 == _e3151));
let _e3162 = (_e3158 - select(0i, 1i, (_e3151 < f32(_e3158))));
let _e3163 = f32(_e3162);
let _e3167 = ((_e3145 - (_e3163 * 0.6933594f)) - (_e3163 * -2.1219444e-4f));
let _e3190 = -((_e2900 * (_e2792 * _e2677.member)));
let _e3192 = select(-87f, _e3190, (_e3190 > -87f));
let _e3194 = select(88f, _e3192, (_e3192 < 88f));
let _e3196 = ((_e3194 * 1.442695f) + 0.5f);
let _e3198 = select(-127f, _e3196, (_e3196 > -127f));
let _e3200 = select(128f, _e3198, (_e3198 < 128f));
let _e3207 = select(0i, select(select(i32(_e3200), i32(-2147483648), (_e3200 < -2147483600f)), 2147483647i, (_e3200 > 2147483500f)), (_e3200 == _e3200));
let _e3211 = (_e3207 - select(0i, 1i, (_e3200 < f32(_e3207))));
let _e3212 = f32(_e3211);
let _e3216 = ((_e3194 - (_e3212 * 0.6933594f)) - (_e3212 * -2.1219444e-4f));
let _e3236 = ((1f + (_e3216 * (1f + (_e3216 * (0.5f + (_e3216 * (0.16666667f + (_e3216 * (0.041666668f + (_e3216 * (0.008333334f + (_e3216 * (0.001388889f + (_e3216 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3211 + 127i)) << bitcast<u32>(23i))));
let _e3237 = (1f - _e3236);
phi_9242_ = type_22(_e3236, _e3237, vec3<f32>(((1f + (_e3071 * (1f + (_e3071 * (0.5f + (_e3071 * (0.16666667f + (_e3071 * (0.041666668f + (_e3071 * (0.008333334f + (_e3071 * (0.001388889f + (_e3071 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3066 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3119 * (1f + (_e3119 * (0.5f + (_e3119 * (0.16666667f + (_e3119 * (0.041666668f + (_e3119 * (0.008333334f + (_e3119 * (0.001388889f + (_e3119 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3114 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3167 * (1f + (_e3167 * (0.5f + (_e3167 * (0.16666667f + (_e3167 * (0.041666668f + (_e3167 * (0.008333334f + (_e3167 * (0.001388889f + (_e3167 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3162 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e3237 / select(1e-12f, _e2900, (_e2900 > 1e-12f))))));
}
let _e3409 = phi_9242_;
if _e743 {
let _e3413 = global_1.member.member_4.member_2;
let _e3421 = global_1.member.member_24.member_2;
let _e3424 = (_e2198.member_3.x * _e2677.member_2);
let _e3426 = (_e2198.member_3.y * _e2677.member_2);
let _e3428 = (_e2198.member_3.z * _e2677.member_2);
let _e3429 = (0.5f * (_e3413 / select(1e-6f, _e185, (_e185 > 1e-6f))));
let _e3433 = (_e163 + (_e3424 * _e3429));
let _e3434 = (_e174 + (_e3426 * _e3429));
let _e3435 = (_e185 + (_e3428 * _e3429));
let _e3437 = (2f * _e3413);
let _e3439 = ((_e3435 * _e3435) + (_e3437 * _e3428));
let _e3443 = (_e3435 + sqrt(select(0f, _e3439, (_e3439 > 0f))));
let _e3447 = (0.5f * (_e3437 / select(1e-6f, _e3443, (_e3443 > 1e-6f))));
let _e3451 = (_e3433 + (_e3424 * _e3447));
let _e3452 = (_e3434 + (_e3426 * _e3447));
let _e3453 = (_e3435 + (_e3428 * _e3447));
let _e3457 = (_e3421 * _e3421);
let _e3459 = (_e3453 * _e3453);
let _e3467 = (((_e3435 <= 0f) || (_e3439 <= 0f)) || ((_e3453 <= 0f) || (_e3459 <= (_e3457 * (((_e3451 * _e3451) + (_e3452 * _e3452)) + _e3459)))));
let _e3481 = (_e163 + ((_e2198.member_4.x * _e2677.member_2) * _e3413));
let _e3482 = (_e174 + ((_e2198.member_4.y * _e2677.member_2) * _e3413));
let _e3483 = (_e185 + ((_e2198.member_4.z * _e2677.member_2) * _e3413));
let _e3485 = (_e3483 * _e3483);
let _e3494 = ((_e2480 & 1u) != 0u);
let _e3498 = select(_e3467, ((_e3483 <= 0f) || (_e3485 <= (_e3457 * (((_e3481 * _e3481) + (_e3482 * _e3482)) + _e3485)))), _e3494);
phi_9393_ = select(select(select(_e3453, _e3435, _e3467), _e3483, _e3494), _e185, _e3498);
phi_9394_ = select(select(select(_e3452, _e3434, _e3467), _e3482, _e3494), _e174, _e3498);
phi_9395_ = select(select(select(_e3451, _e3433, _e3467), _e3481, _e3494), _e163, _e3498);
phi_9396_ = select(1f, 0f, _e3498);
} else {
phi_9393_ = _e185;
phi_9394_ = _e174;
phi_9395_ = _e163;
phi_9396_ = 1f;
}
let _e3504 = phi_9393_;
let _e3506 = phi_9394_;
let _e3508 = phi_9395_;
let _e3510 = phi_9396_;
let _e3513 = (_e3409.member * _e3510);
global_5.member[_e120] = (_e131 * (_e3409.member_2.x * _e3513));
global_5.member[_e132] = (_e141 * (_e3409.member_2.y * _e3513));
global_5.member[_e143] = (_e152 * (_e3409.member_2.z * _e3513));
global_5.member[_e154] = _e3508;
global_5.member[_e165] = _e3506;
global_5.member[_e176] = _e3504;
global_5.member[_e187] = _e196;
global_5.member[_e198] = _e207;
global_5.member[_e209] = _e218;
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
